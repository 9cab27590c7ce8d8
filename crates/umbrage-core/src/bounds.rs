//! What the planner needs to know of a world: the box around it, and the boxes of what is in it.

use glam::{DVec3, Vec3};

use crate::cull::ConvexVolume;
use crate::plane_set::PlaneSet;
use crate::tree::{Below, Search, Tree};

/// An axis-aligned box in world space, metres. It is empty when any `min` exceeds its `max`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// The smallest coordinates inside.
    pub min: Vec3,
    /// The largest coordinates inside.
    pub max: Vec3,
}

/// What a planner knows of a world. It is made once, and told what moves ([`Self::set`]): a tree over the boxes of things finds
/// those that matter to a view, so that a plan costs little more where they are many.
#[derive(Clone, Debug)]
pub struct Bounds {
    /// The box of the world, where that is not the one around all objects.
    world: Option<Aabb>,
    objects: Vec<Aabb>,
    tree: Tree,
    /// The number of objects that nothing can be planned for.
    unbounded: usize,
}

impl Bounds {
    /// Makes a world of which only the outer box is known; it stands for all that is in it.
    pub fn of_world(min: Vec3, max: Vec3) -> Self {
        Self::within(Aabb { min, max }, Vec::new())
    }

    /// Makes a world of things with these boxes, for fits that depend on the scene. Boxes that hold nothing are allowed: they
    /// are room for things that come later.
    pub fn new(objects: Vec<Aabb>) -> Self {
        let unbounded = objects.iter().filter(|aabb| aabb.is_unbounded()).count();
        Self { world: None, tree: Tree::of(&objects), objects, unbounded }
    }

    /// Makes the same in a box that stays as it is: everything lies in it that casts or receives. Where there are no objects,
    /// it stands for all of them.
    pub fn within(world: Aabb, objects: Vec<Aabb>) -> Self {
        Self { world: Some(world), ..Self::new(objects) }
    }

    /// Returns the box in which everything lies that casts or receives.
    pub fn world(&self) -> Aabb {
        self.world.unwrap_or_else(|| self.tree.root())
    }

    /// Returns the boxes of the things in the world, in the order in which they were given.
    pub fn objects(&self) -> &[Aabb] {
        &self.objects
    }

    /// Moves objects: each of these, by its number among [`Self::objects`], has another box now. Numbers that are too large
    /// are passed over. The costs are those of what moved, not of what is there.
    pub fn set(&mut self, moved: impl IntoIterator<Item = (usize, Aabb)>) {
        for (number, aabb) in moved {
            let Some(object) = self.objects.get_mut(number) else { continue };
            if *object != aabb {
                self.unbounded -= usize::from(object.is_unbounded());
                self.unbounded += usize::from(aabb.is_unbounded());
                *object = aabb;
                self.tree.note(number);
            }
        }
        self.tree.refit(&self.objects);
    }

    /// Gives `found` the numbers of all objects that may touch a volume, as [`ConvexVolume::may_touch_box`] says it, in no
    /// order. Those whose boxes hold nothing are not among them.
    pub fn touching(&self, volume: &ConvexVolume, found: impl FnMut(u32)) {
        // Where something has no end, sums may not be numbers, and nothing is said of many boxes at once.
        let is_finite = self.tree.root().is_finite();
        let mut search = Touching { volume, is_finite, objects: &self.objects, found };
        self.tree.search(&mut search, PlaneSet::first(volume.planes().len()));
    }

    /// The tree over all objects.
    pub(crate) fn tree(&self) -> &Tree {
        &self.tree
    }

    /// Whether all boxes have ends, or hold nothing at all: else nothing can be planned.
    pub(crate) fn can_be_planned(&self) -> bool {
        self.unbounded == 0 && !self.world.is_some_and(Aabb::is_unbounded)
    }

    /// Returns the distance from a point to the nearest box, metres; 0 within a box, and infinite where there is none.
    pub(crate) fn distance_from(&self, point: DVec3) -> f64 {
        let mut nearest = Nearest { point, objects: &self.objects, square: f64::INFINITY };
        match self.world {
            Some(world) if self.objects.is_empty() => nearest.add(&world),
            Some(_) | None => self.tree.search(&mut nearest, ()),
        }
        nearest.square.sqrt()
    }
}

impl PartialEq for Bounds {
    /// Two are equal where their boxes are.
    fn eq(&self, other: &Self) -> bool {
        self.world() == other.world() && self.objects == other.objects
    }
}

/// A search for what may touch a volume. Its state is the planes that cut what was seen so far.
struct Touching<'a, F> {
    volume: &'a ConvexVolume,
    is_finite: bool,
    objects: &'a [Aabb],
    found: F,
}

impl<F: FnMut(u32)> Search for Touching<'_, F> {
    type State = PlaneSet;

    fn node(&mut self, around: &Aabb, planes: PlaneSet) -> Below<PlaneSet> {
        match self.volume.across(around, planes) {
            None => Below::Nothing,
            Some(_) if !self.is_finite => Below::Some(planes),
            Some(across) if across.is_empty() => Below::All(across),
            Some(across) => Below::Some(across),
        }
    }

    fn boxes(&mut self, numbers: &[u32], planes: PlaneSet) {
        for &number in numbers {
            let aabb = &self.objects[number as usize];
            if !aabb.is_empty() && self.volume.may_touch_across(aabb, planes) {
                (self.found)(number);
            }
        }
    }
}

/// A search for the box that is nearest to a point.
struct Nearest<'a> {
    point: DVec3,
    objects: &'a [Aabb],
    /// The least square of a distance so far.
    square: f64,
}

impl Nearest<'_> {
    fn square_from(&self, aabb: &Aabb) -> f64 {
        let (min, max) = (aabb.min.as_dvec3(), aabb.max.as_dvec3());
        (min - self.point).max(self.point - max).max(DVec3::ZERO).length_squared()
    }

    fn add(&mut self, aabb: &Aabb) {
        if !aabb.is_empty() {
            self.square = self.square.min(self.square_from(aabb));
        }
    }
}

impl Search for Nearest<'_> {
    type State = ();

    fn node(&mut self, around: &Aabb, (): ()) -> Below<()> {
        if self.square_from(around) < self.square { Below::Some(()) } else { Below::Nothing }
    }

    fn boxes(&mut self, numbers: &[u32], (): ()) {
        for &number in numbers {
            let aabb = self.objects[number as usize];
            self.add(&aabb);
        }
    }
}

impl Aabb {
    /// The box that holds nothing.
    pub const EMPTY: Self = Self { min: Vec3::INFINITY, max: Vec3::NEG_INFINITY };

    /// Returns the smallest box that holds both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// Whether nothing lies inside.
    pub fn is_empty(self) -> bool {
        !self.min.cmple(self.max).all()
    }

    /// Whether it has an end on every side.
    pub(crate) fn is_finite(self) -> bool {
        self.min.is_finite() && self.max.is_finite()
    }

    /// Whether it is neither finite nor the box that holds nothing.
    fn is_unbounded(self) -> bool {
        !self.is_finite() && self != Self::EMPTY
    }

    /// The middle; `None` where nothing lies inside.
    pub(crate) fn middle(self) -> Option<Vec3> {
        (!self.is_empty()).then(|| 0.5 * self.min + 0.5 * self.max)
    }

    /// The middle, and half of each side.
    pub(crate) fn centre_and_half(self) -> (DVec3, DVec3) {
        let (min, max) = (self.min.as_dvec3(), self.max.as_dvec3());
        ((min + max) * 0.5, (max - min) * 0.5)
    }

    /// Returns the eight corners, x fastest.
    pub fn corners(self) -> [Vec3; 8] {
        std::array::from_fn(|i| {
            let pick = |bit: usize, low: f32, high: f32| if i >> bit & 1 == 0 { low } else { high };
            Vec3::new(
                pick(0, self.min.x, self.max.x),
                pick(1, self.min.y, self.max.y),
                pick(2, self.min.z, self.max.z),
            )
        })
    }

    pub(crate) fn corners_f64(self) -> [DVec3; 8] {
        self.corners().map(Vec3::as_dvec3)
    }
}

#[cfg(test)]
mod tests;
