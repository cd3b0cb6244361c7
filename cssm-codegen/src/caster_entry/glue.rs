//! The generated part between the engine's functions and the library: what the vertex stage takes, how the engine is
//! called, and the stages of casters with holes. Written under the library's names; the engine's stand as placeholders
//! until composing has given every other name its prefix.

use std::fmt::Write;

use cssm_core::table::{CasterSpace, ShaderKind};

use super::signature::{Argument, Attribute, HoleResult, Signature, Varying, VaryingSource, free_name};

/// Names of the instance rows in the vertex stage's input.
const ROWS: [&str; 3] = ["eye_from_object_x", "eye_from_object_y", "eye_from_object_z"];

/// Generated text whose placeholders stand for names of the engine's.
#[derive(Debug, Clone, Default)]
pub(super) struct Glue {
    /// What stands before the library's functions.
    pub(super) head: String,
    /// What stands behind them.
    pub(super) tail: String,
    names: Vec<String>,
}

/// What the glue of a module depends on.
#[derive(Debug, Clone, Copy)]
pub(super) struct GlueOf<'a> {
    pub(super) signature: &'a Signature,
    pub(super) position: &'a str,
    pub(super) hole: Option<(&'a str, HoleResult, f32)>,
    pub(super) space: CasterSpace,
    pub(super) clipped: bool,
    pub(super) clamped: bool,
    /// Every name that the engine declares at module scope.
    pub(super) engine_names: &'a [&'a str],
    /// Names that no member of a generated struct may have.
    pub(super) reserved: &'a [String],
}

impl Glue {
    /// The glue of a module.
    pub(super) fn new(of: GlueOf) -> Self {
        let mut glue = Self::default();
        glue.inputs(&of);
        glue.calls(&of);
        if of.hole.is_some() {
            glue.hole(&of);
            glue.stages(&of);
        }
        glue
    }

    /// Puts the engine's names in the place of their placeholders.
    pub(super) fn named(&self, text: &str) -> String {
        let replace =
            |text: String, (number, name): (usize, &String)| text.replace(&placeholder(number), name);
        self.names.iter().enumerate().fold(text.to_owned(), replace)
    }

    /// The placeholder of a name of the engine's.
    fn engine(&mut self, name: &str) -> String {
        let known = self.names.iter().position(|known| known == name);
        let number = known.unwrap_or_else(|| {
            self.names.push(name.to_owned());
            self.names.len() - 1
        });
        placeholder(number)
    }

    /// What the vertex stage takes, and the uniform rows.
    fn inputs(&mut self, of: &GlueOf) {
        if let CasterSpace::World { group, binding } = of.space {
            line(
                &mut self.head,
                "/// Where the engine's origin stands: rows that take its positions to the capture's axes.",
            );
            line(&mut self.head, &format!("@group({group}) @binding({binding})"));
            line(&mut self.head, "var<uniform> caster_rows: array<vec4<f32>, 3>;\n");
        }
        let position = self.engine(of.position);
        let object = match of.space {
            CasterSpace::Object { .. } => ", and where its object stands",
            CasterSpace::World { .. } | CasterSpace::Capture => "",
        };
        line(&mut self.head, &format!("/// What `{position}` takes of a vertex{object}."));
        line(&mut self.head, "struct CasterVertex {");
        for input in &of.signature.inputs {
            let attribute = match input.attribute {
                Attribute::Location(location) => format!("@location({location})"),
                Attribute::Builtin(name) => format!("@builtin({name})"),
            };
            line(&mut self.head, &format!("    {attribute} {}: {},", input.name, input.ty));
        }
        if let CasterSpace::Object { first_location } = of.space {
            let docs = [
                "First of the instance's rows; they take the object's space to the capture's axes, relative to the eye.",
                "Second row.",
                "Third row.",
            ];
            for ((location, doc), name) in (first_location..).zip(docs).zip(rows(of)) {
                line(&mut self.head, &format!("    /// {doc}"));
                line(&mut self.head, &format!("    @location({location}) {name}: vec4<f32>,"));
            }
        }
        line(&mut self.head, "}\n");
    }

    /// The call of the position function, and what the library makes of a vertex without holes.
    fn calls(&mut self, of: &GlueOf) {
        let function = self.engine(of.position);
        let vertex = free_name("vertex", |name| of.engine_names.contains(&name));
        let input = |number: &usize| format!("{vertex}.{}", of.signature.inputs[*number].name);
        let arguments: Vec<_> = of
            .signature
            .arguments
            .iter()
            .map(|argument| match argument {
                Argument::Input(number) => input(number),
                Argument::Struct { name, inputs } => {
                    let inputs: Vec<_> = inputs.iter().map(input).collect();
                    format!("{}({})", self.engine(name), inputs.join(", "))
                }
            })
            .collect();
        let call = format!("{function}({})", arguments.join(", "));
        let result = match &of.signature.result_struct {
            Some(name) => self.engine(name),
            None => "vec3<f32>".to_owned(),
        };
        line(&mut self.head, "/// What the engine makes of a vertex.");
        line(&mut self.head, &format!("fn engine_caster({vertex}: CasterVertex) -> {result} {{"));
        if call.len() + 16 <= LINE_LIMIT {
            line(&mut self.head, &format!("    return {call};"));
        } else {
            line(&mut self.head, &format!("    return {function}("));
            arguments.iter().for_each(|argument| line(&mut self.head, &format!("        {argument},")));
            line(&mut self.head, "    );");
        }
        line(&mut self.head, "}\n");
        if of.hole.is_none() {
            let position = position_of(of, "engine_caster(vertex)");
            line(&mut self.head, "/// Moves a vertex to where the engine puts it, into the capture's axes.");
            line(&mut self.head, "fn capture_position(vertex: CasterVertex) -> vec4<f32> {");
            line(&mut self.head, &format!("    return {};", placed(of, &position)));
            line(&mut self.head, "}\n");
        }
    }

    /// Whether the engine leaves a fragment out.
    fn hole(&mut self, of: &GlueOf) {
        let Some((hole, result, cutoff)) = of.hole else { return };
        let function = self.engine(hole);
        let name = |varying: &Varying| free_name(&varying.name, |name| of.engine_names.contains(&name));
        let varyings = &of.signature.hole;
        let parameters: Vec<_> =
            varyings.iter().map(|varying| format!("{}: {}", name(varying), varying.ty)).collect();
        let arguments: Vec<_> = varyings.iter().map(name).collect();
        let mut test = format!("{function}({})", arguments.join(", "));
        if result == HoleResult::Alpha {
            line(&mut self.tail, "/// Alpha below which a caster has a hole.");
            line(&mut self.tail, &format!("const ALPHA_CUTOFF: f32 = {cutoff:?};\n"));
            test.push_str(" < ALPHA_CUTOFF");
        }
        line(
            &mut self.tail,
            "/// Whether the engine's caster has a hole; it may take derivatives, so every fragment must call it.",
        );
        line(&mut self.tail, &format!("fn is_hole({}) -> bool {{", parameters.join(", ")));
        line(&mut self.tail, &format!("    return {test};"));
        line(&mut self.tail, "}\n");
    }

    /// The stages of casters with holes.
    fn stages(&mut self, of: &GlueOf) {
        let kind = if of.clamped { ShaderKind::CaptureTestedClamped } else { ShaderKind::CaptureTested };
        let name = kind.name();
        let out = &mut self.tail;

        // What stages share: the library's part first, then what the hole function takes.
        let own = match (of.clamped, of.clipped) {
            (false, false) => &["tile"][..],
            (false, true) => &["tile", "clips"],
            (true, false) => &["tile", "depth_times_w", "w"],
            (true, true) => &["tile", "depth_times_w", "w", "clips"],
        };
        let first_location = if of.clamped { own.len() as u32 - 1 } else { 0 };
        let taken = |name: &str| own.contains(&name) || of.reserved.iter().any(|reserved| reserved == name);
        let shared = |varying: &Varying| free_name(&varying.name, taken);
        let shared_member = |(location, varying): (u32, &Varying)| {
            let flat = if varying.flat { "@interpolate(flat) " } else { "" };
            format!("@location({location}) {flat}{}: {}", shared(varying), varying.ty)
        };
        let varyings = &of.signature.hole;
        let members: Vec<_> = (first_location..).zip(varyings).map(shared_member).collect();

        line(out, "/// What the vertex stage hands to the pipeline and to the fragment stage.");
        line(out, "struct TestedCaster {");
        let hidden = if of.clamped { ", at a depth that no clip plane meets" } else { "" };
        line(out, &format!("    /// Position in the tile{hidden}."));
        line(out, "    @builtin(position) tile: vec4<f32>,");
        if of.clamped {
            line(out, "    /// Clip z of the facet: depth times w.");
            line(out, "    @location(0) depth_times_w: f32,");
            line(out, "    /// Clip w of the facet.");
            line(out, "    @location(1) w: f32,");
        }
        match (of.clipped, of.clamped) {
            (false, _) => {}
            (true, false) => {
                line(
                    out,
                    "    /// Distances from the facet's half-spaces; the pipeline cuts where one is negative.",
                );
                line(out, "    @builtin(clip_distances) clips: array<f32, 2>,");
            }
            (true, true) => {
                line(out, "    /// Distances from the facet's half-spaces.");
                line(out, "    @location(2) clips: vec2<f32>,");
            }
        }
        members.iter().for_each(|member| line(out, &format!("    {member},")));
        line(out, "}\n");

        // Place the vertex.
        line(out, "/// Places a caster's vertex in the tile.");
        line(out, "@vertex");
        line(out, &format!("fn {name}_vertex(vertex: CasterVertex) -> TestedCaster {{"));
        line(out, "    let caster = engine_caster(vertex);");
        line(out, &format!("    let position = {};", placed(of, &position_of(of, "caster"))));
        line(out, "    let tile = tile_position(position);");
        let mut values = match of.clamped {
            true => vec!["hidden_depth(tile)".to_owned(), "tile.z".into(), "tile.w".into()],
            false => vec!["tile".to_owned()],
        };
        match (of.clipped, of.clamped) {
            (false, _) => {}
            (true, false) => {
                line(out, "    let clips = clip_values(position);");
                values.push("array<f32, 2>(clips.x, clips.y)".into());
            }
            (true, true) => values.push("clip_values(position)".into()),
        }
        values.extend(varyings.iter().map(|varying| match &varying.source {
            VaryingSource::Result(member) => format!("caster.{member}"),
            VaryingSource::Input(number) => format!("vertex.{}", of.signature.inputs[*number].name),
        }));
        line(out, "    return TestedCaster(");
        values.iter().for_each(|value| line(out, &format!("        {value},")));
        line(out, "    );");
        line(out, "}\n");

        // Leave holes out.
        let names: Vec<_> = varyings.iter().map(shared).collect();
        line(out, "/// Leaves the caster's holes out.");
        line(out, "@fragment");
        if of.clamped {
            line(out, &format!("fn {name}_fragment(caster: TestedCaster) -> @builtin(frag_depth) f32 {{"));
            let names: Vec<_> = names.iter().map(|name| format!("caster.{name}")).collect();
            line(out, &format!("    let hole = is_hole({});", names.join(", ")));
            let cut = if of.clipped { " || is_cut(caster.clips)" } else { "" };
            line(out, &format!("    if hole{cut} {{"));
        } else {
            line(out, &format!("fn {name}_fragment({}) {{", members.join(", ")));
            line(out, &format!("    if is_hole({}) {{", names.join(", ")));
        }
        line(out, "        discard;\n    }");
        if of.clamped {
            line(out, "    return clamped_depth(caster.depth_times_w, caster.w);");
        }
        line(out, "}\n");
    }
}

/// Longest line of generated text.
const LINE_LIMIT: usize = 116;

fn placeholder(number: usize) -> String {
    format!("cssm_engine_{number}_name")
}

/// The position in what the engine makes of a vertex.
fn position_of(of: &GlueOf, caster: &str) -> String {
    let member = if of.signature.result_struct.is_some() { ".position" } else { "" };
    format!("{caster}{member}")
}

/// A position of the engine's in the capture's axes.
fn placed(of: &GlueOf, position: &str) -> String {
    match of.space {
        CasterSpace::Object { .. } => {
            let [x, y, z] = rows(of);
            format!(
                "placed(\n        {position},\n        vertex.{x},\n        vertex.{y},\n        vertex.{z},\n    )"
            )
        }
        CasterSpace::World { .. } => {
            format!(
                "placed(\n        {position},\n        caster_rows[0],\n        caster_rows[1],\n        \
                 caster_rows[2],\n    )"
            )
        }
        CasterSpace::Capture => format!("vec4<f32>({position}, 1.0)"),
    }
}

/// Names of the instance rows beside the engine's inputs.
fn rows(of: &GlueOf) -> [String; 3] {
    ROWS.map(|row| free_name(row, |name| of.signature.inputs.iter().any(|input| input.name == name)))
}

fn line(text: &mut String, line: &str) {
    // Writing to a string cannot fail.
    let _ = writeln!(text, "{line}");
}
