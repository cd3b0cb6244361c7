//! What there is to measure: cases, and the keys by which their results are recognised.

use std::hash::Hasher as _;
use std::path::Path;

use cssm_core::case::{FIELDS, Filter, LightKind, MAP_SIDE_LIMIT_TEXELS};
use cssm_core::schema::{Field, Value};
use cssm_core::technique::TECHNIQUES;
use cssm_core::{LightCase, SceneBounds, plan};
use fnv::FnvHasher;

use super::error::MeasureError;
use super::paths::ViewPath;
use super::results::CaseEntry;
use super::variants::{self, Form};
use crate::case_file::with_map_size;
use crate::error::LabError;
use crate::scene::Scene;

/// Raised whenever the way of judging changes, so that no older number is taken over.
const METHOD: u32 = 2;

/// Filter of cases that do not say.
const CUSTOMARY_FILTER: Filter = Filter::Gather2x2;

/// Cases to choose from on the command line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum CaseChoice {
    /// Every form of every technique.
    All,
    /// Every technique in its variants, with its default configurations and distribution.
    Variants,
    /// The forms of some techniques.
    Techniques(Vec<String>),
    /// The cases of a declaration file.
    File(String),
}

/// A case with a size and a filter.
#[derive(Debug, Clone, PartialEq)]
pub struct Item {
    /// Index of its entry.
    pub entry: usize,
    /// The case.
    pub case: LightCase,
}

impl CaseChoice {
    /// What `--cases` means: `all`, `variants`, a `.cssm` file, or names of techniques.
    pub fn of(text: &str) -> Self {
        match text {
            "all" => Self::All,
            "variants" => Self::Variants,
            file if file.ends_with(".cssm") => Self::File(file.to_owned()),
            names => Self::Techniques(names.split(',').map(|name| name.trim().to_owned()).collect()),
        }
    }

    /// The chosen cases for some kinds of light, at every side and with every filter; without filters, with their own.
    ///
    /// # Errors
    /// When a file cannot be read, a name is unknown or nothing is left.
    pub fn items(
        &self,
        lights: &[LightKind],
        sides: &[u32],
        filters: &[Filter],
    ) -> Result<(Vec<CaseEntry>, Vec<Item>), LabError> {
        let (mut entries, mut items) = (Vec::new(), Vec::new());
        match self {
            Self::File(path) => {
                for case in file_cases(path)?.into_iter().filter(|case| lights.contains(&case.light)) {
                    let own = [case.filter];
                    let filters = if filters.is_empty() { &own } else { filters };
                    for (side, filter) in every(sides, filters) {
                        let case = LightCase { filter, ..with_map_size(case.clone(), (side, side))? };
                        items.push(Item { entry: entries.len(), case });
                    }
                    entries.push(file_entry(&case));
                }
            }
            Self::All | Self::Variants | Self::Techniques(_) => {
                let filters = if filters.is_empty() { &[CUSTOMARY_FILTER] } else { filters };
                for form in self.forms(lights)? {
                    for (side, filter) in every(sides, filters) {
                        // The text grammar allows the same sides.
                        let case = with_map_size(form.case(sides[0], filter)?, (side, side))?;
                        items.push(Item { entry: entries.len(), case });
                    }
                    entries.push(entry(&form, sides[0], filters[0]));
                }
            }
        }
        if items.is_empty() {
            let lights = lights.iter().map(|light| light.name()).collect();
            return Err(MeasureError::NothingToMeasure { lights }.into());
        }
        Ok((entries, items))
    }

    fn forms(&self, lights: &[LightKind]) -> Result<Vec<Form>, MeasureError> {
        let known = || TECHNIQUES.iter().map(|spec| spec.choice.name);
        if let Self::Techniques(names) = self
            && let Some(name) = names.iter().find(|name| !known().any(|known| known == name.as_str()))
        {
            return Err(MeasureError::NoSuchTechnique { name: name.clone(), known: known().collect() });
        }
        let wanted = |form: &Form| match self {
            Self::Techniques(names) => names.iter().any(|name| name == form.technique),
            Self::Variants => form.rows.is_empty(),
            Self::All | Self::File(_) => true,
        };

        // Forms that spell out another one's defaults declare the same case.
        let (mut forms, mut cases) = (Vec::new(), Vec::new());
        for form in lights.iter().flat_map(|light| variants::forms(*light)).filter(wanted) {
            let case =
                LightCase { name: String::new(), ..form.case(MAP_SIDE_LIMIT_TEXELS, CUSTOMARY_FILTER)? };
            if !cases.contains(&case) {
                forms.push(form);
                cases.push(case);
            }
        }
        Ok(forms)
    }
}

fn every<'a>(sides: &'a [u32], filters: &'a [Filter]) -> impl Iterator<Item = (u32, Filter)> + 'a {
    sides.iter().flat_map(|side| filters.iter().map(|filter| (*side, *filter)))
}

fn entry(form: &Form, side: u32, filter: Filter) -> CaseEntry {
    let spec = TECHNIQUES.iter().find(|spec| spec.choice.name == form.technique);
    let first = spec.and_then(|spec| spec.variants.first());
    CaseEntry {
        label: form.label(),
        technique: form.technique.to_owned(),
        customary: form.rows.is_empty() && first.is_some_and(|first| *first == form.declared),
        house: form.technique == house(),
        declaration: form.declaration(side, filter),
    }
}

fn file_entry(case: &LightCase) -> CaseEntry {
    CaseEntry {
        label: case.name.clone(),
        technique: case.technique.name.to_owned(),
        customary: true,
        house: case.technique.name == house(),
        declaration: String::new(),
    }
}

/// The technique that a declaration without any stands for.
fn house() -> &'static str {
    let field = Field::find(FIELDS, "technique").and_then(Field::default_value);
    match field {
        Some(Value::Word(word)) => word.name,
        _ => TECHNIQUES[0].choice.name,
    }
}

fn file_cases(path: &str) -> Result<Vec<LightCase>, LabError> {
    let read = std::fs::read_to_string(path);
    let text = read.map_err(|source| LabError::ReadCase { path: path.into(), source })?;
    let cases = cssm_codegen::dsl::parse_file(path, &text)
        .map_err(|report| LabError::Declaration { report: report.render() })?;
    if cases.is_empty() {
        return Err(LabError::NoCases { path: Path::new(path).to_owned() });
    }
    Ok(cases)
}

/// What all cells of a run share.
#[derive(Debug, Clone)]
pub struct Keys {
    ground: u64,
    bounds: SceneBounds,
}

impl Keys {
    /// Hashes the scene and how it is judged.
    pub fn new(scene: &Scene, judged: &str) -> Self {
        let mut hash = FnvHasher::default();
        hash.write_u32(METHOD);
        hash.write(env!("CARGO_PKG_VERSION").as_bytes());
        hash.write(judged.as_bytes());
        for mesh in &scene.meshes {
            mesh.positions.iter().flatten().for_each(|value| hash.write_u32(value.to_bits()));
            mesh.indices.iter().for_each(|index| hash.write_u32(*index));
            if let Some(mask) = &mesh.mask {
                hash.write(format!("{mask:?}").as_bytes());
            }
        }
        for instance in &scene.instances {
            hash.write_usize(instance.mesh);
            hash.write(format!("{:?}", instance.world_from_object).as_bytes());
        }
        Self { ground: hash.finish(), bounds: SceneBounds::of(scene.bounds_world()) }
    }

    /// Key of a case on a path: the declaration, the stations, what is planned and generated for them, and
    /// whether a device draws it.
    pub fn key(&self, case: &LightCase, shaders: u64, path: &ViewPath, drawn: bool) -> String {
        let mut hash = FnvHasher::default();
        hash.write_u64(self.ground);
        hash.write_u64(shaders);
        hash.write_u8(u8::from(drawn));
        hash.write(format!("{case:?}").as_bytes());
        for station in &path.stations {
            hash.write(format!("{station:?}").as_bytes());
            let plan = plan(case, &station.view, &station.light, &self.bounds);
            hash.write(format!("{plan:?}").as_bytes());
        }
        format!("{:016x}", hash.finish())
    }
}

/// Hash of what is generated for a case.
///
/// # Errors
/// When the generator is at fault.
pub fn shaders_hash(case: &LightCase) -> Result<u64, LabError> {
    let generated = cssm_codegen::generate(case)?;
    let mut hash = FnvHasher::default();
    generated.table.shaders.iter().for_each(|shader| hash.write(&shader.spirv));
    Ok(hash.finish())
}
