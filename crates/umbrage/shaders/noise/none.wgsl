// The same number everywhere.

/// From 0 to 1.
fn umbrage_noise(receiver: UmbrageReceiver) -> f32 {
    return 0.0;
}
