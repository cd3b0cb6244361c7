//! What the engine's functions take and return, and how the generated part calls them.

use std::ops::Range;

use naga::{BuiltIn, Function, Handle, ScalarKind, Type, TypeInner, VectorSize};

use super::pieces::{self, Item, Piece};
use super::report::{CasterFinding, CasterPlace};

/// How the engine's functions are called.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Signature {
    /// What the vertex stage takes for the position function, each once.
    pub(super) inputs: Vec<Input>,
    /// The position function's arguments.
    pub(super) arguments: Vec<Argument>,
    /// Name of the struct that it returns, if it returns one with a `position`.
    pub(super) result_struct: Option<String>,
    /// What the hole function takes, in order.
    pub(super) hole: Vec<Varying>,
}

/// An input of the vertex stage.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Input {
    pub(super) attribute: Attribute,
    /// Name in the generated struct.
    pub(super) name: String,
    /// Name in the engine's source.
    pub(super) source_name: String,
    /// WGSL type.
    pub(super) ty: String,
    place: CasterPlace,
    handle: Handle<Type>,
}

/// Where an input comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Attribute {
    Location(u32),
    Builtin(&'static str),
}

/// An argument of the position function: an input, or a struct of inputs; by number.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Argument {
    Input(usize),
    Struct { name: String, inputs: Vec<usize> },
}

/// What the vertex stage hands to the hole function.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Varying {
    /// Name of the hole function's parameter.
    pub(super) name: String,
    pub(super) ty: String,
    /// Whether it is the same all over a triangle: numbers that are not floats are.
    pub(super) flat: bool,
    pub(super) source: VaryingSource,
}

/// Where a varying comes from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum VaryingSource {
    /// A member of what the position function returns.
    Result(String),
    /// An input of the vertex stage, by number.
    Input(usize),
}

/// What a hole function returns.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum HoleResult {
    Bool,
    Alpha,
}

/// Reads the functions of a module of reached pieces.
pub(super) struct Reader<'a> {
    pub(super) module: &'a naga::Module,
    pub(super) pieces: &'a [Piece<'a>],
    /// Names that no member of a generated struct may have.
    pub(super) reserved: &'a [String],
    pub(super) findings: Vec<CasterFinding>,
}

impl<'a> Reader<'a> {
    /// The signature of the position function and the hole function.
    pub(super) fn signature(&mut self, position: &str, hole: Option<(&str, HoleResult)>) -> Signature {
        let mut signature = Signature::default();
        let Some((function, piece, head)) = self.function(position) else { return signature };
        for (argument, item) in function.arguments.iter().zip(&head.parameters) {
            self.parameter(argument, &piece, item, &mut signature);
        }
        if signature.inputs.is_empty() && self.findings.is_empty() {
            self.findings.push(CasterFinding::at(
                piece.name_place(),
                format!("`{position}` takes nothing, so every vertex would have the same position"),
                "take a struct of `@location` members, or `@builtin(vertex_index) vertex: u32`",
            ));
        }
        self.same_locations(&signature);
        let results = self.position_result(&function, &piece, &head, &mut signature);
        if let Some((hole, result)) = hole {
            self.hole(hole, result, position, &results, &mut signature);
        }
        signature
    }

    fn function(&self, name: &str) -> Option<(Function, Piece<'a>, pieces::Head)> {
        let (_, function) =
            self.module.functions.iter().find(|(_, function)| function.name.as_deref() == Some(name))?;
        let piece = pieces::function(self.pieces, name)?;
        Some((function.clone(), piece.clone(), pieces::head(piece.text)?))
    }

    /// Adds a parameter of the position function: an attributed one, or a struct of attributed members.
    fn parameter(
        &mut self,
        argument: &naga::FunctionArgument,
        piece: &Piece,
        item: &Item,
        signature: &mut Signature,
    ) {
        let name = argument.name.clone().unwrap_or_default();
        if let TypeInner::Struct { members, .. } = &self.module.types[argument.ty].inner {
            let struct_name = self.module.types[argument.ty].name.clone().unwrap_or_default();
            let declared = self.pieces.iter().find(|piece| piece.name() == struct_name).cloned();
            let items = declared.as_ref().map(|piece| pieces::members(piece.text)).unwrap_or_default();
            let mut inputs = Vec::new();
            for (index, member) in members.iter().enumerate() {
                let place = match (&declared, items.get(index)) {
                    (Some(declared), Some(item)) => declared.place(item.whole.clone()),
                    _ => piece.place(item.whole.clone()),
                };
                let member_name = member.name.clone().unwrap_or_default();
                let owner = Some(struct_name.as_str());
                inputs.extend(self.input(&member.binding, member.ty, &member_name, owner, place, signature));
            }
            signature.arguments.push(Argument::Struct { name: struct_name, inputs });
            return;
        }
        let place = piece.place(item.whole.clone());
        if let Some(input) = self.input(&argument.binding, argument.ty, &name, None, place, signature) {
            signature.arguments.push(Argument::Input(input));
        }
    }

    /// Adds an input, or finds the one that already holds the same built-in value.
    fn input(
        &mut self,
        binding: &Option<naga::Binding>,
        ty: Handle<Type>,
        name: &str,
        owner: Option<&str>,
        place: CasterPlace,
        signature: &mut Signature,
    ) -> Option<usize> {
        let attribute = match binding {
            Some(naga::Binding::Location { location, .. }) => Attribute::Location(*location),
            Some(naga::Binding::BuiltIn(BuiltIn::VertexIndex)) => Attribute::Builtin("vertex_index"),
            Some(naga::Binding::BuiltIn(BuiltIn::InstanceIndex)) => Attribute::Builtin("instance_index"),
            Some(naga::Binding::BuiltIn(_)) => {
                let message = format!("`{name}` is a built-in value that no vertex stage of a capture takes");
                let remedy = "take `vertex_index`, `instance_index` or vertex attributes with `@location`";
                self.findings.push(CasterFinding::at(place, message, remedy));
                return None;
            }
            None => {
                let message = match owner {
                    Some(owner) => format!("member `{name}` of `{owner}` comes from nowhere"),
                    None => format!("parameter `{name}` comes from nowhere"),
                };
                let remedy = format!("say which vertex attribute it is, such as `@location(n) {name}`");
                self.findings.push(CasterFinding::at(place, message, remedy));
                return None;
            }
        };
        let Some((ty_text, _)) = self.shared_type(ty) else {
            let message = format!("`{name}` has a type that no vertex attribute has");
            let remedy = "use f32, i32, u32 or vectors of them; spread a matrix over its columns";
            self.findings.push(CasterFinding::at(place, message, remedy));
            return None;
        };
        let known = signature.inputs.iter().position(|input| input.attribute == attribute);
        if let (Some(known), Attribute::Builtin(_)) = (known, attribute) {
            return Some(known);
        }
        let taken = |name: &str| {
            signature.inputs.iter().any(|input| input.name == name)
                || self.reserved.iter().any(|reserved| reserved == name)
        };
        signature.inputs.push(Input {
            attribute,
            name: free_name(name, taken),
            source_name: name.to_owned(),
            ty: ty_text,
            place,
            handle: ty,
        });
        Some(signature.inputs.len() - 1)
    }

    /// Finds locations that two inputs share.
    fn same_locations(&mut self, signature: &Signature) {
        for (index, input) in signature.inputs.iter().enumerate() {
            let same = |earlier: &&Input| earlier.attribute == input.attribute;
            if let (Some(earlier), Attribute::Location(location)) =
                (signature.inputs[..index].iter().find(same), input.attribute)
            {
                let message = format!("location {location} is taken twice");
                let finding =
                    CasterFinding::at(input.place.clone(), message, "give one of them another location");
                self.findings.push(finding.and(earlier.place.clone(), "taken here first"));
            }
        }
    }

    /// Checks what the position function returns; the members beside the position.
    fn position_result(
        &mut self,
        function: &Function,
        piece: &Piece,
        head: &pieces::Head,
        signature: &mut Signature,
    ) -> Vec<(String, Handle<Type>)> {
        let place = piece.place(head.result.clone().unwrap_or(0..piece.text.len().min(2)));
        let name = piece.name();
        let ty = function.result.as_ref().map(|result| &self.module.types[result.ty]);
        let finding = match ty {
            None => CasterFinding::at(
                piece.name_place(),
                format!("`{name}` returns no position"),
                "return `vec3<f32>`, or a struct with `position: vec3<f32>` and what a hole function takes",
            ),
            Some(ty) if is_position(&ty.inner) => return Vec::new(),
            Some(Type { name: struct_name, inner: TypeInner::Struct { members, .. } }) => {
                let position = members.iter().find(|member| member.name.as_deref() == Some("position"));
                if position.is_some_and(|member| is_position(&self.module.types[member.ty].inner)) {
                    signature.result_struct = struct_name.clone();
                    let others = members.iter().filter(|member| member.name.as_deref() != Some("position"));
                    return others
                        .map(|member| (member.name.clone().unwrap_or_default(), member.ty))
                        .collect();
                }
                let struct_name = struct_name.clone().unwrap_or_default();
                let message = format!("`{struct_name}` has no member `position` of type vec3<f32>");
                CasterFinding::at(
                    place,
                    message,
                    "add `position: vec3<f32>` to it, or return the position alone",
                )
                .labelled(format!("what `{name}` returns"))
            }
            Some(ty) => {
                let message = format!("`{name}` returns {}, not a position", self.type_name(&ty.inner));
                let remedy = match ty.inner {
                    TypeInner::Vector { size: VectorSize::Quad, .. } => {
                        "return `vec3<f32>`: the position before any projection, `.xyz` of a point with w = 1"
                    }
                    _ => "return `vec3<f32>`, or a struct with `position: vec3<f32>`",
                };
                CasterFinding::at(place, message, remedy).labelled("expected vec3<f32>")
            }
        };
        self.findings.push(finding);
        Vec::new()
    }

    /// Checks the hole function, and finds where each of its parameters comes from.
    fn hole(
        &mut self,
        hole: &str,
        result: HoleResult,
        position: &str,
        results: &[(String, Handle<Type>)],
        signature: &mut Signature,
    ) {
        let Some((function, piece, head)) = self.function(hole) else { return };
        let returned = function.result.as_ref().map(|result| &self.module.types[result.ty].inner);
        let returns =
            |kind: ScalarKind| matches!(returned, Some(TypeInner::Scalar(scalar)) if scalar.kind == kind);
        let (expected, fits, remedy) = match result {
            HoleResult::Bool => (
                "bool",
                returns(ScalarKind::Bool),
                "return `bool`, true where the caster has a hole, or name the function by `alpha` with a cutoff",
            ),
            HoleResult::Alpha => (
                "f32",
                returns(ScalarKind::Float),
                "return `f32`, the alpha that the cutoff is compared with, or name the function by `hole`",
            ),
        };
        if !fits {
            let place = head.result.clone().map_or(piece.name_place(), |result| piece.place(result));
            let found = returned.map_or("nothing".to_owned(), |inner| self.type_name(inner));
            let message = format!("`{hole}` returns {found}");
            self.findings
                .push(CasterFinding::at(place, message, remedy).labelled(format!("expected {expected}")));
        }
        for (argument, item) in function.arguments.iter().zip(&head.parameters) {
            let place = piece.place(item.whole.clone());
            let name = argument.name.clone().unwrap_or_default();
            signature.hole.extend(self.varying(&name, argument.ty, place, position, results, signature));
        }
    }

    /// Finds what a parameter of the hole function is called by: a member of the result, or an input.
    fn varying(
        &mut self,
        name: &str,
        ty: Handle<Type>,
        place: CasterPlace,
        position: &str,
        results: &[(String, Handle<Type>)],
        signature: &Signature,
    ) -> Option<Varying> {
        let result = results.iter().find(|(member, _)| member == name);
        let input = signature.inputs.iter().position(|input| input.source_name == name);
        let (source, found) = match (result, input) {
            (Some((member, found)), _) => (VaryingSource::Result(member.clone()), *found),
            (None, Some(input)) => (VaryingSource::Input(input), signature.inputs[input].handle),
            (None, None) => {
                let what = self.type_name(&self.module.types[ty].inner);
                self.findings.push(
                    CasterFinding::at(
                        place,
                        format!("nothing is called `{name}` that the vertex stage could hand over"),
                        format!(
                            "let `{position}` take `@location(n) {name}: {what}`, or return it in a struct beside \
                             `position`"
                        ),
                    )
                    .labelled(format!("`{position}` neither takes nor returns it")),
                );
                return None;
            }
        };
        if found != ty {
            let (is, wants) = (&self.module.types[found].inner, &self.module.types[ty].inner);
            let message =
                format!("`{name}` is {}, but {} is asked for", self.type_name(is), self.type_name(wants));
            self.findings.push(CasterFinding::at(place, message, "use one type in both places"));
            return None;
        }
        let Some((ty, flat)) = self.shared_type(ty) else {
            let message = format!("`{name}` has a type that stages cannot hand over");
            self.findings.push(CasterFinding::at(place, message, "use f32, i32, u32 or vectors of them"));
            return None;
        };
        Some(Varying { name: name.to_owned(), ty, flat, source })
    }

    /// WGSL of a type that stages can share, and whether it must be flat.
    fn shared_type(&self, ty: Handle<Type>) -> Option<(String, bool)> {
        let inner = &self.module.types[ty].inner;
        let (TypeInner::Scalar(scalar) | TypeInner::Vector { scalar, .. }) = inner else { return None };
        let shared = matches!(scalar.kind, ScalarKind::Float | ScalarKind::Sint | ScalarKind::Uint);
        (shared && scalar.width == 4).then(|| (self.type_name(inner), scalar.kind != ScalarKind::Float))
    }

    fn type_name(&self, inner: &TypeInner) -> String {
        let scalar = |kind: ScalarKind| match kind {
            ScalarKind::Sint | ScalarKind::AbstractInt => "i32",
            ScalarKind::Uint => "u32",
            ScalarKind::Float | ScalarKind::AbstractFloat => "f32",
            ScalarKind::Bool => "bool",
        };
        match inner {
            TypeInner::Scalar(one) => scalar(one.kind).to_owned(),
            TypeInner::Vector { size, scalar: one } => format!("vec{}<{}>", *size as u8, scalar(one.kind)),
            TypeInner::Matrix { columns, rows, scalar: one } => {
                format!("mat{}x{}<{}>", *columns as u8, *rows as u8, scalar(one.kind))
            }
            TypeInner::Struct { .. } => "a struct".to_owned(),
            TypeInner::Array { .. } => "an array".to_owned(),
            _ => "another type".to_owned(),
        }
    }
}

fn is_position(inner: &TypeInner) -> bool {
    matches!(inner, TypeInner::Vector { size: VectorSize::Tri, scalar } if *scalar == naga::Scalar::F32)
}

/// A name that is not taken: the name itself, or with as many suffixes as it takes.
pub(super) fn free_name(name: &str, taken: impl Fn(&str) -> bool) -> String {
    let mut free = name.to_owned();
    while taken(&free) {
        free.push_str("_own");
    }
    free
}

/// Locations that inputs take.
pub(super) fn locations(inputs: &[Input]) -> impl Iterator<Item = (u32, &Input)> {
    inputs.iter().filter_map(|input| match input.attribute {
        Attribute::Location(location) => Some((location, input)),
        Attribute::Builtin(_) => None,
    })
}

impl Input {
    /// Where the engine declares it.
    pub(super) fn place(&self) -> &CasterPlace {
        &self.place
    }
}

/// The part of a piece that says nothing but its first word, for faults of the piece as a whole.
pub(super) fn first_word(piece: &Piece) -> Range<usize> {
    pieces::words(piece.text).next().map_or(0..0, |(bytes, _)| bytes)
}
