/// Stands for a visibility that is not known without a ray.
const UMBRAGE_UNDECIDED: f32 = -1.0;
