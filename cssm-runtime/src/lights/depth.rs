//! Depth of views as the device measured it: recorded where the engine has drawn it, taken up by later plans of the same
//! view, and never waited for.

use cssm_core::View;
use cssm_core::fit::DepthHistogram;
use cssm_core::table::{BindingKind, CaseTable, GroupContent, ShaderKind};

use super::description::{LightFrame, ViewId};
use super::{LightService, ServedCase};
use crate::error::ServiceError;
use crate::fit::DepthReduction;

/// Frames after which measured depth tells nothing any more.
const OLDEST_FRAMES: u32 = 30;

/// What is measured of a view.
#[derive(Debug)]
pub(super) struct ObservedDepth {
    pub(super) view: ViewId,
    /// `None` where no case asks for it, or the device cannot measure.
    reduction: Option<DepthReduction>,
    newest: Option<DepthHistogram>,
    /// Whether depth was recorded since the view was prepared last.
    is_recorded: bool,
}

impl LightService {
    /// Records the measurement of a view's depth, for cases whose fit asks for it: later calls of
    /// [`LightService::prepare`] plan by the newest measurement that has come, with its age. Record it in any encoder
    /// behind the passes that draw `depth`; one that is dropped takes its measurement along. Says whether this frame is
    /// measured: it is not where no case asks for it, on devices without the limits of
    /// [`depth_reduction_requirements`](crate::depth_reduction_requirements), and while earlier frames are on their way.
    ///
    /// `depth` is what the mask pass of those cases takes. What was measured late only moves texels to where pixels are:
    /// without it, or with a wrong one, no shadow is missing. [`LightFrame::depth`] takes precedence.
    ///
    /// # Errors
    /// [`ServiceError::Refused`] for a texture of another kind than the cases declare, and whatever else the device refuses.
    pub fn observe_depth(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        view_id: ViewId,
        view: &View,
        depth: &wgpu::TextureView,
    ) -> Result<bool, ServiceError> {
        let known = self.depths.iter().position(|known| known.view == view_id);
        let index = match known {
            Some(index) => index,
            None => {
                let reduction = match measuring(&self.cases, depth) {
                    Some(table) => DepthReduction::new(&self.device, &self.queue, table)?,
                    None => None,
                };
                let fresh = ObservedDepth { view: view_id, reduction, newest: None, is_recorded: false };
                self.depths.push(fresh);
                self.depths.len() - 1
            }
        };
        let observed = &mut self.depths[index];
        let Some(reduction) = &mut observed.reduction else { return Ok(false) };
        observed.is_recorded = true;
        let is_measured = reduction.record(encoder, depth, view)?;
        reduction.read_on_submit(encoder);
        Ok(is_measured)
    }

    /// The measured depth that a view's last frame was planned with, unless the engine gave its own; `None` where none has
    /// come, or none for a while.
    pub fn observed_depth(&self, view_id: ViewId) -> Option<&DepthHistogram> {
        self.depths.iter().find(|known| known.view == view_id)?.newest.as_ref()
    }

    /// What is known of the depth of a frame that is being prepared.
    pub(super) fn depth_now(&mut self, frame: &LightFrame) -> Option<DepthHistogram> {
        let observed = self.depths.iter_mut().find(|known| known.view == frame.view_id)?;
        observed.advance();
        observed.newest
    }
}

impl ObservedDepth {
    /// Begins another frame: takes up what has come, and lets what has not been replaced grow older.
    fn advance(&mut self) {
        let Some(reduction) = &mut self.reduction else { return };
        if !std::mem::take(&mut self.is_recorded) {
            reduction.pass_frame();
        }
        match reduction.newest() {
            Ok(Some(newest)) => self.newest = Some(newest),
            Ok(None) => {
                self.newest = self.newest.and_then(|known| {
                    let latency_frames = known.latency_frames.saturating_add(1);
                    (latency_frames <= OLDEST_FRAMES).then_some(DepthHistogram { latency_frames, ..known })
                });
            }
            // A lost device is told by what follows; plans do without depth.
            Err(_) => (self.newest, self.reduction) = (None, None),
        }
    }
}

/// The table of a case that measures depth of a texture's kind, or at least depth.
fn measuring<'c>(cases: &'c [ServedCase], depth: &wgpu::TextureView) -> Option<&'c CaseTable> {
    let wanted = match depth.texture().format().is_depth_stencil_format() {
        true => BindingKind::SceneDepth,
        false => BindingKind::SceneLinearDepth,
    };
    let takes = |table: &CaseTable| {
        let group = table.group(ShaderKind::Fit, GroupContent::Fit);
        group.is_some_and(|group| group.bindings.iter().any(|binding| binding.kind == wanted))
    };
    let tables =
        || cases.iter().map(|served| served.service.table()).filter(|table| table.reduction.is_some());
    tables().find(|table| takes(table)).or_else(|| tables().next())
}
