//! The value tree against the schema: from what is written to checked arguments.

use cssm_core::LightCase;
use cssm_core::case::{CaseError, FIELDS};
use cssm_core::schema::{self, Arguments, Choice, Default, Field, Kind, Unit, Value, Word};
use proc_macro2::Span;

use super::diagnostic::{Diagnostic, Faults};
use super::item::Item;
use super::suggest;
use super::tree::{Entry, Node, NodeKind, NumberNode, WordNode};

/// Checks one case; its faults are pushed, and then there is no case.
pub(super) fn case(item: &Item, faults: &mut Faults) -> Option<LightCase> {
    let before = faults.0.len();
    let mut check = Check { faults, spans: Vec::new(), faulty: Vec::new() };
    let arguments = check.entries(FIELDS, &item.entries, "", false);
    let Check { spans, faulty, .. } = check;

    // Look for contradictions between the fields that hold.
    match LightCase::from_arguments(&item.name, &item.doc, item.public, &arguments) {
        Ok(case) => (faults.0.len() == before).then_some(case),
        Err(errors) => {
            let blameless = |error: &&CaseError| {
                let mut fields = error.related().iter().copied().chain([top_level(&error.field)]);
                !fields.any(|field| faulty.iter().any(|faulty| faulty == field))
            };
            faults.0.extend(errors.iter().filter(blameless).map(|error| placed(error, item, &spans)));
            None
        }
    }
}

/// A contradiction at the place of its field, with the first field that it contradicts.
fn placed(error: &CaseError, item: &Item, spans: &[(String, Span)]) -> Diagnostic {
    // Take the innermost written field on the path; a field that is left out is blamed on the name.
    let mut path = error.field.as_str();
    let span = loop {
        if let Some((_, span)) = spans.iter().find(|(written, _)| written == path) {
            break *span;
        }
        match path.rsplit_once('.') {
            Some((outer, _)) => path = outer,
            None => break item.name_span,
        }
    };
    let diagnostic = Diagnostic::new(span, error.message.clone(), error.remedy.clone());
    match error.related().iter().find_map(|field| spans.iter().find(|(written, _)| written == field)) {
        Some((field, span)) => diagnostic.with_secondary(*span, format!("`{field}` is declared here")),
        None => diagnostic,
    }
}

struct Check<'a> {
    faults: &'a mut Faults,
    /// Where the value of each dotted path stands.
    spans: Vec<(String, Span)>,
    /// Top-level fields that hold a fault.
    faulty: Vec<String>,
}

impl Check<'_> {
    /// Checks the entries of a group; `positional`: the first may be the first field without its name.
    fn entries(
        &mut self,
        fields: &'static [Field],
        entries: &[Entry],
        path: &str,
        positional: bool,
    ) -> Arguments {
        let mut written: Vec<(&str, Span)> = Vec::new();
        let mut arguments = Arguments::default();
        for (index, entry) in entries.iter().enumerate() {
            let Some((field, span)) = self.field(fields, entry, path, positional && index == 0) else {
                self.mark(path);
                continue;
            };
            let path = join(path, field.name);
            if let Some((_, first)) = written.iter().find(|(name, _)| *name == field.name) {
                let message = format!("field `{}` stands twice", field.name);
                let diagnostic = Diagnostic::new(span, message, "keep one of them");
                self.faults.0.push(diagnostic.with_secondary(*first, "first written here"));
                self.mark(&path);
                continue;
            }
            written.push((field.name, span));
            let value = entry.value.as_ref().and_then(|node| {
                self.spans.push((path.clone(), node.span));
                self.value(field, node, &path)
            });
            match value {
                Some(value) => arguments.0.push((field.name, value)),
                None => self.mark(&path),
            }
        }
        arguments
    }

    /// The field an entry belongs to, and the place to blame.
    fn field(
        &mut self,
        fields: &'static [Field],
        entry: &Entry,
        path: &str,
        positional: bool,
    ) -> Option<(&'static Field, Span)> {
        let names: Vec<_> = fields.iter().map(|field| field.name).collect();
        match (&entry.name, &entry.value) {
            (Some((name, span)), _) => match Field::find(fields, name) {
                Some(field) => Some((field, *span)),
                None => {
                    let place = if path.is_empty() { String::new() } else { format!(" in `{path}`") };
                    let message = format!("there is no field `{name}`{place}");
                    self.faults.push(*span, message, suggest::for_field(name, fields, path));
                    None
                }
            },
            (None, _) if positional => fields.first().map(|field| (field, entry.span)),
            (None, Some(Node { kind: NodeKind::Word(word), .. }))
                if Field::find(fields, &word.name).is_some() =>
            {
                let field = Field::find(fields, &word.name)?;
                let message = format!("field `{}` has no value", word.name);
                self.faults.push(entry.span, message, format!("write `{}: {}`", word.name, example(field)));
                None
            }
            // A value that could not be read has been reported.
            (None, None) => None,
            (None, Some(_)) => {
                let remedy = format!("write `name: value`; the names here are {}", suggest::listed(&names));
                self.faults.push(entry.span, "a value stands without a field name", remedy);
                None
            }
        }
    }

    fn value(&mut self, field: &Field, node: &Node, path: &str) -> Option<Value> {
        let value = match (&field.kind, &node.kind) {
            (Kind::Count { .. } | Kind::AutoOrCount { .. }, NodeKind::Number(number)) => {
                Value::Count(self.count(field, number, path)?)
            }
            (Kind::AutoOrCount { .. }, NodeKind::Word(word)) if word.name == "auto" => {
                self.choice(&[Choice::plain("auto", "")], word, path).map(Value::Word)?
            }
            (Kind::Number { unit, .. } | Kind::NumberOr { unit, .. }, NodeKind::Number(number)) => {
                self.quantity(*unit, number, path)?
            }
            (Kind::Size { .. }, NodeKind::Size(width, height)) => {
                let (width, height) = self.size(field, width, height, path)?;
                Value::Size(width, height)
            }
            (Kind::SizeList { min, max }, NodeKind::List(nodes)) => {
                let side = Field { kind: Kind::Size { min: *min, max: *max }, ..*field };
                let sizes = nodes.iter().map(|node| match self.value(&side, node.as_ref()?, path) {
                    Some(Value::Size(width, height)) => Some((width, height)),
                    _ => None,
                });
                // Check every entry before giving up on the list.
                let sizes: Vec<_> = sizes.collect();
                Value::Sizes(sizes.into_iter().collect::<Option<_>>()?)
            }
            (Kind::Choice(choices) | Kind::NumberOr { choices, .. }, NodeKind::Word(word)) => {
                self.choice(choices, word, path).map(Value::Word)?
            }
            (Kind::ChoiceList(choices), NodeKind::List(nodes)) => {
                self.choices(field, choices, nodes, path)?
            }
            (Kind::Group(fields), NodeKind::Group(entries)) => {
                Value::Group(self.entries(fields, entries, path, false))
            }
            (Kind::Prefix, NodeKind::Word(word)) if word.arguments.is_empty() => {
                Value::Name(word.name.clone())
            }
            _ => {
                self.wrong_kind(field, node);
                return None;
            }
        };
        match field.kind.check(&value) {
            Ok(()) => Some(value),
            Err(schema::Fault { message, remedy }) => {
                self.faults.push(node.span, format!("`{path}`: {message}"), remedy);
                None
            }
        }
    }

    /// A chosen name with its arguments.
    fn choice(&mut self, choices: &[Choice], word: &WordNode, path: &str) -> Option<Word> {
        let field = path.rsplit('.').next().unwrap_or(path);
        let Some(choice) = Choice::find(choices, &word.name) else {
            let message = format!("`{path}` cannot be `{}`", word.name);
            self.faults.push(word.span, message, suggest::for_choice(&word.name, choices, field));
            return None;
        };
        if let ([], [first, ..]) = (choice.arguments, word.arguments.as_slice()) {
            let message = format!("`{}` takes no arguments", choice.name);
            self.faults.push(first.span, message, format!("write `{}`", choice.name));
            return None;
        }
        let arguments = self.entries(choice.arguments, &word.arguments, path, word.positional);
        Some(Word { name: choice.name, arguments })
    }

    /// Chosen names in a list, each once.
    fn choices(
        &mut self,
        field: &Field,
        choices: &[Choice],
        nodes: &[Option<Node>],
        path: &str,
    ) -> Option<Value> {
        let mut words: Vec<(Word, Span)> = Vec::new();
        let mut sound = nodes.iter().all(Option::is_some);
        for node in nodes.iter().flatten() {
            let NodeKind::Word(word) = &node.kind else {
                self.wrong_kind(field, node);
                sound = false;
                continue;
            };
            let path = join(path, &word.name);
            self.spans.push((path.clone(), node.span));
            match self.choice(choices, word, &path) {
                Some(word) => match words.iter().find(|(earlier, _)| earlier.name == word.name) {
                    Some((_, first)) => {
                        let message = format!("`{}` stands twice in the list", word.name);
                        let diagnostic = Diagnostic::new(node.span, message, "name it once");
                        self.faults.0.push(diagnostic.with_secondary(*first, "first named here"));
                        sound = false;
                    }
                    None => words.push((word, node.span)),
                },
                None => sound = false,
            }
        }
        sound.then(|| Value::Words(words.into_iter().map(|(word, _)| word).collect()))
    }

    /// A whole number that fits 32 bits.
    fn count(&mut self, field: &Field, number: &NumberNode, path: &str) -> Option<u32> {
        if let Some((unit, span)) = &number.unit {
            let message = format!("`{path}` takes no unit, but `{unit}` follows");
            self.faults.push(*span, message, format!("write `{}`", number.text));
            return None;
        }
        let text = &number.text;
        let count = match number.whole {
            Some(whole) => u32::try_from(whole).map_err(|_| format!("`{path}`: {text} is too large")),
            None if number.value < 0.0 => Err(format!("`{path}`: {text} is negative")),
            None => Err(format!("`{path}`: {text} is not a whole number")),
        };
        count.map_err(|message| self.faults.push(number.span, message, format!("use {}", field.kind))).ok()
    }

    fn size(
        &mut self,
        field: &Field,
        width: &NumberNode,
        height: &NumberNode,
        path: &str,
    ) -> Option<(u32, u32)> {
        let (width, height) = (self.count(field, width, path), self.count(field, height, path));
        Some((width?, height?))
    }

    /// A real number in base units.
    fn quantity(&mut self, unit: Unit, number: &NumberNode, path: &str) -> Option<Value> {
        let text = &number.text;
        let units = suggest::listed(unit.names());
        let name = number.unit.as_ref().map_or("", |(name, _)| name.as_str());
        if let Some(value) = unit.base(number.value, name) {
            return Some(Value::Number(value));
        }
        let (span, message, remedy) = match (&number.unit, unit) {
            (Some((name, span)), Unit::None) => {
                (*span, format!("`{path}` takes no unit, but `{name}` follows"), format!("write `{text}`"))
            }
            (Some((name, span)), _) => {
                (*span, format!("`{path}`: `{name}` is not a unit here"), format!("use {units}"))
            }
            (None, _) => {
                let remedy = format!("write `{text} {}`; units are {units}", unit.base_name());
                (number.span, format!("`{path}`: {text} has no unit"), remedy)
            }
        };
        self.faults.push(span, message, remedy);
        None
    }

    fn wrong_kind(&mut self, field: &Field, node: &Node) {
        let found = match &node.kind {
            NodeKind::Word(word) => format!("the name `{}`", word.name),
            NodeKind::Number(number) => format!("the number {}", number.text),
            NodeKind::Size(width, height) => format!("the size {} x {}", width.text, height.text),
            NodeKind::List(_) => "a list".into(),
            NodeKind::Group(_) => "a group in braces".into(),
        };
        let remedy = match (&field.kind, &node.kind, field.default) {
            (Kind::ChoiceList(choices), NodeKind::Word(word), _)
                if Choice::find(choices, &word.name).is_some() =>
            {
                format!("write `[{}]`", word.name)
            }
            (Kind::Choice([only]), NodeKind::Group(_), _) => format!("write `{} {{ .. }}`", only.name),
            (kind, _, Default::Absent(absent)) => format!("use {kind}; left out, {absent}"),
            (kind, ..) => format!("use {kind}"),
        };
        self.faults.push(node.span, format!("`{}` cannot be {found}", field.name), remedy);
    }

    fn mark(&mut self, path: &str) {
        self.faulty.push(top_level(path).into());
    }
}

/// A value as it may be written, for remedies.
fn example(field: &Field) -> String {
    match (field.default, field.kind) {
        (Default::Value(text), _) => text.into(),
        (_, Kind::Number { unit: Unit::Length, .. }) => "1000 m".into(),
        (_, Kind::Choice([first, ..])) => first.name.into(),
        (_, Kind::ChoiceList([first, ..])) => format!("[{}]", first.name),
        (_, Kind::SizeList { .. }) => "[1024 x 1024, ..]".into(),
        (_, Kind::Prefix) => "sun".into(),
        _ => "..".into(),
    }
}

fn join(path: &str, name: &str) -> String {
    if path.is_empty() { name.into() } else { format!("{path}.{name}") }
}

fn top_level(path: &str) -> &str {
    path.split('.').next().unwrap_or(path)
}
