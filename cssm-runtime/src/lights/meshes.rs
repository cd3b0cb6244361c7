//! Caster meshes as every case knows them: one handle for all.

use super::LightService;
use super::stored::StoredMesh;
use crate::commands::MeshFacts;
use crate::error::ServiceError;
use crate::mesh::{Mesh, MeshDescription, MeshHandle};
use crate::service::ShadowService;

/// Handles of meshes, with the handles of each case behind them.
#[derive(Debug, Default)]
pub(super) struct Meshes {
    entries: Vec<Entry>,
}

#[derive(Debug, Default)]
struct Entry {
    generation: u32,
    /// One for each case; empty for a free entry.
    handles: Vec<MeshHandle>,
    /// For executors that are made later.
    stored: Option<StoredMesh>,
}

impl LightService {
    /// Registers a caster mesh with all cases. Its buffers and the texture of its mask stay the engine's; they are kept
    /// alive until the mesh is removed.
    ///
    /// # Errors
    /// As [`ShadowService::add_mesh`]. Nothing is registered then.
    pub fn add_mesh(&mut self, description: &MeshDescription) -> Result<MeshHandle, ServiceError> {
        let mut handles = Vec::with_capacity(self.cases.len());
        for index in 0..self.cases.len() {
            match self.cases[index].service.add_mesh(description) {
                Ok(handle) => handles.push(handle),
                Err(error) => {
                    for (served, handle) in self.cases.iter_mut().zip(handles) {
                        served.service.remove_mesh(handle);
                    }
                    return Err(error);
                }
            }
        }
        let entries = &mut self.meshes.entries;
        let index = entries.iter().position(|entry| entry.handles.is_empty()).unwrap_or_else(|| {
            entries.push(Entry::default());
            entries.len() - 1
        });
        entries[index].handles = handles;
        entries[index].stored = Some(StoredMesh::new(description));
        Ok(MeshHandle { index: index as u32, generation: entries[index].generation })
    }

    /// Forgets a mesh; returns whether it was known. Frames that draw it become stale.
    pub fn remove_mesh(&mut self, mesh: MeshHandle) -> bool {
        let entry = self.meshes.entries.get_mut(mesh.index as usize);
        let Some(entry) = entry.filter(|entry| entry.generation == mesh.generation) else { return false };
        if entry.handles.is_empty() {
            return false;
        }
        for (served, handle) in self.cases.iter_mut().zip(entry.handles.drain(..)) {
            served.service.remove_mesh(handle);
        }
        entry.stored = None;
        entry.generation = entry.generation.wrapping_add(1);
        true
    }
}

impl Meshes {
    /// A mesh as a case keeps it.
    pub(super) fn mesh<'s>(
        &self,
        service: &'s ShadowService,
        case: usize,
        mesh: MeshHandle,
    ) -> Option<&'s Mesh> {
        let entry = self.entries.get(mesh.index as usize)?;
        let handle = entry.handles.get(case).filter(|_| entry.generation == mesh.generation)?;
        service.mesh(*handle)
    }

    /// What commands of a case need to know of a mesh.
    pub(super) fn facts<'s>(
        &self,
        service: &'s ShadowService,
        case: usize,
        mesh: MeshHandle,
    ) -> Option<MeshFacts<'s>> {
        self.mesh(service, case, mesh).map(Mesh::facts)
    }

    /// Registers all meshes with another executor of a case.
    ///
    /// # Errors
    /// As [`ShadowService::add_mesh`]. Nothing changes here then.
    pub(super) fn add_all_to(
        &mut self,
        service: &mut ShadowService,
        case: usize,
    ) -> Result<(), ServiceError> {
        let add = |entry: &Entry| match &entry.stored {
            Some(stored) => service.add_mesh(&stored.description()).map(Some),
            None => Ok(None),
        };
        let added = self.entries.iter().map(add).collect::<Result<Vec<_>, _>>()?;
        for (entry, handle) in self.entries.iter_mut().zip(added) {
            if let (Some(place), Some(handle)) = (entry.handles.get_mut(case), handle) {
                *place = handle;
            }
        }
        Ok(())
    }

    /// The same handles, none of which is valid any more.
    pub(super) fn of_lost_device(mut self) -> Self {
        for entry in &mut self.entries {
            *entry = Entry { generation: entry.generation.wrapping_add(1), ..Entry::default() };
        }
        self
    }
}
