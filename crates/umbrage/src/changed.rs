//! What a change of settings or lights has remade.

/// What a host must do after settings or lights have changed. What is not remade goes on as it is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Changed {
    /// The maps are new: nothing is drawn in them, and views and groups of before no longer belong to them. Draw all views anew,
    /// and ask again for [`Shadows::bind_group`](crate::Shadows::bind_group).
    pub maps: bool,
    /// Pipelines of [`Shadows::caster_pipeline`](crate::Shadows::caster_pipeline) and its like, and a host's own of
    /// [`CasterState`](crate::CasterState), no longer fit: make them anew.
    pub casters: bool,
    /// The text of [`Shadows::wgsl`](crate::Shadows::wgsl) is another one: make anew the pipelines that ask for visibility.
    pub receivers: bool,
    /// How many GPU objects were made. 0 where all that changed is in the frame.
    pub objects: u32,
}

impl std::ops::BitOr for Changed {
    type Output = Self;

    /// What two changes, one after the other, have remade.
    fn bitor(self, other: Self) -> Self {
        Self {
            maps: self.maps | other.maps,
            casters: self.casters | other.casters,
            receivers: self.receivers | other.receivers,
            objects: self.objects + other.objects,
        }
    }
}
