//! One fault of a declaration, with its place.

use proc_macro2::{Span, TokenStream};
use quote::quote_spanned;

/// One fault of a declaration.
#[derive(Debug, Clone)]
pub struct Diagnostic {
    /// What is wrong; lower-case, no full stop.
    pub message: String,
    /// What to write instead.
    pub remedy: String,
    /// Where it is.
    pub span: Span,
    /// Another place that belongs to the fault, and what stands there.
    pub secondary: Option<(Span, String)>,
}

impl Diagnostic {
    /// A fault at one place.
    pub fn new(span: Span, message: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self { message: message.into(), remedy: remedy.into(), span, secondary: None }
    }

    /// The fault with another place that belongs to it.
    pub fn with_secondary(mut self, span: Span, label: impl Into<String>) -> Self {
        self.secondary = Some((span, label.into()));
        self
    }

    /// A `compile_error!` at the fault's place, with the remedy in its text.
    pub fn to_compile_error(&self) -> TokenStream {
        let text = format!("{}\nhelp: {}", self.message, self.remedy);
        quote_spanned! { self.span => ::core::compile_error! { #text } }
    }
}

/// The faults in the making: whoever finds one goes on looking.
#[derive(Debug, Default)]
pub(super) struct Faults(pub(super) Vec<Diagnostic>);

impl Faults {
    pub(super) fn push(&mut self, span: Span, message: impl Into<String>, remedy: impl Into<String>) {
        self.0.push(Diagnostic::new(span, message, remedy));
    }
}
