//! Objects that exist once for each order in which a table's plans may store depth.

use cssm_core::plan::DepthOrder;
use cssm_core::table::CaseTable;

/// One object for plans that store depth as usual, and another for reversed ones where the table allows them.
#[derive(Debug, Clone)]
pub(crate) struct ByOrder<T> {
    standard: T,
    reversed: Option<T>,
}

impl<T> ByOrder<T> {
    /// Creates what the table's plans can ask for.
    pub(crate) fn new(table: &CaseTable, create: impl Fn(DepthOrder) -> T) -> Self {
        let reversed = table.may_reverse_depth.then(|| create(DepthOrder::Reversed));
        Self { standard: create(DepthOrder::Standard), reversed }
    }

    /// The object for an order. Plans with an order that the table does not allow are refused before they get here.
    pub(crate) fn of(&self, order: DepthOrder) -> &T {
        match (order, &self.reversed) {
            (DepthOrder::Reversed, Some(reversed)) => reversed,
            _ => &self.standard,
        }
    }
}
