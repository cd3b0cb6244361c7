//! One capture module of a caster entry: composed of the engine's part and the generated part, and judged as a whole.

use cssm_core::LightCase;
use cssm_core::table::{CaseTable, CasterShader, CasterSpace, ShaderKind};

use super::glue::{Glue, GlueOf};
use super::pieces::{self, Piece};
use super::signature::Signature;
use super::text::Composed;
use super::{CasterEntry, CasterError, check, validate};
use crate::compose::{self, ComposeError, Prefix};
use crate::generate::{self, GenerateError};
use crate::judge::{self, JudgeError, Judged};
use crate::{library, prelude, spirv, wgsl};

/// The engine's part of every variant.
pub(super) struct EnginePart<'a> {
    pub(super) pieces: &'a [Piece<'a>],
    pub(super) reached: &'a [usize],
    pub(super) signature: &'a Signature,
    pub(super) reserved: &'a [String],
}

impl CasterEntry {
    /// Composes and judges one variant.
    pub(super) fn shader(
        &self,
        case: &LightCase,
        table: &CaseTable,
        part: &EnginePart,
        space: CasterSpace,
        clamped: bool,
    ) -> Result<(CasterShader, Judged), CasterError> {
        let hole = self.hole.as_ref().map(|(name, result, cutoff)| (name.as_str(), *result, *cutoff));
        let base = if clamped { ShaderKind::CaptureClamped } else { ShaderKind::Capture };
        let kind = match (hole.is_some(), clamped) {
            (false, _) => base,
            (true, false) => ShaderKind::CaptureTested,
            (true, true) => ShaderKind::CaptureTestedClamped,
        };
        let prefix = Prefix::new(&case.prefix);
        let names: Vec<_> = part.reached.iter().map(|number| part.pieces[*number].name()).collect();
        let glue = Glue::new(GlueOf {
            signature: part.signature,
            position: &self.position,
            hole,
            space,
            clipped: table.clips > 0,
            clamped,
            engine_names: &names,
            reserved: part.reserved,
        });

        // Compose the generated part.
        let prelude = prelude::prelude(table, base, &prefix);
        let has_rows = !matches!(space, CasterSpace::Capture);
        let files = library::caster_entry(table, clamped, hole.is_some(), has_rows);
        let mut sources = vec![prelude.as_str(), glue.head.as_str()];
        sources.extend(files.iter().map(|file| &*file.source));
        sources.push(&glue.tail);
        let vertex = format!("{}_vertex", kind.name());
        let fragment = (kind != ShaderKind::Capture).then(|| format!("{}_fragment", kind.name()));
        let roots: Vec<_> = std::iter::once(vertex.as_str()).chain(fragment.as_deref()).collect();
        let unnamed = compose::compose(&sources, &roots, &prefix)
            .map_err(|source| self.compose_fault(case, kind, source))?;
        let generated = glue.named(&unnamed);

        // Put the engine's part in front of it.
        let mut composed = Composed::default();
        composed.generated(&self.header(case, table, kind));
        composed.generated(prelude::directives(table, base));
        for number in part.reached {
            composed.piece(*number, &part.pieces[*number]);
            composed.generated("\n\n");
        }
        let first_generated = composed.text.len();
        composed.generated(&generated);

        // Judge the whole.
        let file = (
            format!("{}.{}.{}.wgsl (generated)", case.prefix, self.name, kind.name()),
            composed.text.clone(),
        );
        let number = self.files.len();
        let findings =
            check::names(part.pieces, part.reached, &generated, &unnamed, (first_generated, number));
        self.refuse(findings, vec![file.clone()])?;
        let judged = validate::together(&composed, judge::capabilities(table, base), number)
            .map_err(|finding| {
                finding.or_at(|| pieces::function(part.pieces, &self.position).map(Piece::name_place))
            })
            .map_err(|finding| self.report(vec![finding], vec![file]))?;
        let fault = |source: JudgeError| self.judge_fault(case, kind, source);
        check::generated_part(&judged.module, table, base, &names).map_err(fault)?;
        let spirv = spirv::write_checked(&judged).map_err(fault)?;
        let emitted = |name: String| prefix.apply(wgsl::DeclarationKind::Function, &name);
        let shader = CasterShader {
            kind,
            wgsl: composed.text.into(),
            spirv: spirv.into(),
            vertex: emitted(vertex).into(),
            fragment: fragment.map(|fragment| emitted(fragment).into()),
        };
        Ok((shader, judged))
    }

    /// The first lines of a module.
    fn header(&self, case: &LightCase, table: &CaseTable, kind: ShaderKind) -> String {
        let what = generate::what_it_is(kind, table.clips > 0);
        let files: Vec<_> = self.files.iter().map(|file| file.name.as_str()).collect();
        let files = generate::doc_lines(&files.join(", ")).join(" ");
        let (fingerprint, position, axes) = (table.fingerprint, &self.position, generate::CAPTURE_AXES);
        format!(
            "// {}: {what}\n// Casters are placed by `{position}` of {files}; what it reaches is copied from there.\n\
             // Facets are relative to the eye, in\n// {axes}.\n\
             // Composed of light case `{}`, {fingerprint:016x}, and caster entry `{}`. Do not edit.\n\n",
            case.name, case.name, self.name
        )
    }

    fn compose_fault(&self, case: &LightCase, kind: ShaderKind, source: ComposeError) -> CasterError {
        GenerateError::Compose { case: case.name.clone(), shader: kind.name(), source }.into()
    }

    fn judge_fault(&self, case: &LightCase, kind: ShaderKind, source: JudgeError) -> CasterError {
        GenerateError::Judge { case: case.name.clone(), shader: kind.name(), source }.into()
    }
}
