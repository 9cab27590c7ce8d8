/// Stands for the index of a view where no view serves a receiver.
const UMBRAGE_NO_VIEW: u32 = 0xffffffffu;
