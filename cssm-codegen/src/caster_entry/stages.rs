//! What functions use that only fragment stages have, where positions are computed; and the other way round.

use std::collections::BTreeSet;
use std::ops::Range;

use naga::valid::ShaderStages;
use naga::{Block, Expression, Function, Handle, SampleLevel, Statement};

use super::pieces::{self, Piece};
use super::report::CasterFinding;
use super::text::Composed;
use crate::judge::Judged;

/// Operations of the position function in the vertex stage, and of the hole function in the fragment stage, that the stage
/// lacks: each where it is written.
pub(super) fn faults(
    judged: &Judged,
    composed: &Composed,
    pieces: &[Piece],
    roots: &[&str],
) -> Vec<CasterFinding> {
    let mut findings = Vec::new();
    let stages = [(ShaderStages::VERTEX, "vertex"), (ShaderStages::FRAGMENT, "fragment")];
    for (root, (stage, stage_name)) in roots.iter().zip(stages) {
        for handle in calls(&judged.module, root) {
            if judged.info[handle].available_stages.contains(stage) {
                continue;
            }
            let function = &judged.module.functions[handle];
            let name = function.name.as_deref().unwrap_or_default();
            for bytes in fragment_operations(function) {
                let message = format!("`{name}` runs in the {stage_name} stage, which cannot do this");
                let remedy = "take no derivatives where positions are computed: use `textureSampleLevel` or \
                              `textureLoad`, and discard nothing";
                let place = composed.place(bytes, usize::MAX);
                let finding = CasterFinding::at(place, message, remedy);
                findings.push(match pieces::function(pieces, root) {
                    Some(piece) if piece.name() != name => {
                        finding.and(piece.name_place(), "which is called from here")
                    }
                    _ => finding,
                });
            }
        }
    }
    findings
}

/// The functions that a function calls, itself included, in order.
fn calls(module: &naga::Module, root: &str) -> BTreeSet<Handle<Function>> {
    let named = |(handle, function): (Handle<Function>, &Function)| {
        (function.name.as_deref() == Some(root)).then_some(handle)
    };
    let mut open: Vec<_> = module.functions.iter().find_map(named).into_iter().collect();
    let mut called = BTreeSet::new();
    while let Some(handle) = open.pop() {
        if called.insert(handle) {
            for_each_statement(&module.functions[handle].body, &mut |statement, _| {
                if let Statement::Call { function, .. } = statement {
                    open.push(*function);
                }
            });
        }
    }
    called
}

/// Bytes of derivatives, samples with an implicit level, and discards.
fn fragment_operations(function: &Function) -> Vec<Range<usize>> {
    let is_one = |expression: &Expression| {
        matches!(
            expression,
            Expression::Derivative { .. }
                | Expression::ImageSample { level: SampleLevel::Auto | SampleLevel::Bias(_), .. }
        )
    };
    let expressions = function.expressions.iter().filter(|(_, expression)| is_one(expression));
    let mut found: Vec<_> =
        expressions.filter_map(|(handle, _)| function.expressions.get_span(handle).to_range()).collect();
    for_each_statement(&function.body, &mut |statement, span| {
        if matches!(statement, Statement::Kill) {
            found.extend(span.to_range());
        }
    });
    found
}

/// Visits the statements of a block and of those inside it.
fn for_each_statement(block: &Block, visit: &mut dyn FnMut(&Statement, naga::Span)) {
    for (statement, span) in block.span_iter() {
        visit(statement, *span);
        match statement {
            Statement::Block(block) => for_each_statement(block, visit),
            Statement::If { accept, reject, .. } => {
                for_each_statement(accept, visit);
                for_each_statement(reject, visit);
            }
            Statement::Switch { cases, .. } => {
                cases.iter().for_each(|case| for_each_statement(&case.body, visit));
            }
            Statement::Loop { body, continuing, .. } => {
                for_each_statement(body, visit);
                for_each_statement(continuing, visit);
            }
            _ => {}
        }
    }
}
