//! The functions of this crate for JavaScript.
//!
//! Texts are UTF-8 in the module's memory. JavaScript takes room by `text_room`, writes a text there and hands over its address and length;
//! the called function frees it. Answers go to the imported `ertel_answer` as address and length and are valid during that call. All
//! imports are in the module `ertel`: `ertel_answer`, `ertel_progress` and `ertel_panic` (address, length), `ertel_seconds` for the clock.

#![allow(unsafe_code)]

use std::panic;
use std::sync::Once;

use serde_json::{Value, json};

use crate::failure::Failure;

mod page {
    #[link(wasm_import_module = "ertel")]
    unsafe extern "C" {
        pub fn ertel_answer(start: *const u8, length: usize);
        pub fn ertel_progress(start: *const u8, length: usize);
        pub fn ertel_panic(start: *const u8, length: usize);
        pub safe fn ertel_seconds() -> f64;
    }
}

type Receiver = unsafe extern "C" fn(*const u8, usize);

fn send(receiver: Receiver, text: &str) {
    // SAFETY: address and length are those of a text that lives until the call ends; JavaScript only reads it.
    unsafe { receiver(text.as_ptr(), text.len()) }
}

fn send_answer(value: &Value) {
    send(page::ertel_answer, &value.to_string());
}

/// Sets the clock, lets dense products use the SIMD that the module is compiled for, and passes the text of a panic to the page before the module stops.
fn start() {
    static STARTED: Once = Once::new();
    STARTED.call_once(|| {
        ertel_fem::platform::set_clock(|| page::ertel_seconds());
        gemm::set_wasm_simd128(cfg!(target_feature = "simd128"));
        panic::set_hook(Box::new(|info| send(page::ertel_panic, &info.to_string())));
    });
}

/// Room for a text of so many bytes.
#[unsafe(no_mangle)]
extern "C" fn text_room(length: usize) -> *mut u8 {
    start();
    Box::into_raw(vec![0u8; length].into_boxed_slice()).cast()
}

/// The text that JavaScript wrote into memory of the module.
///
/// # Safety
/// `start` and `length` are those of one call of [`text_room`], and are handed over once.
unsafe fn taken(start: *mut u8, length: usize) -> String {
    // SAFETY: as the caller promises, the slice was made by `text_room` and belongs to nobody else.
    let bytes = unsafe { Box::from_raw(std::ptr::slice_from_raw_parts_mut(start, length)) };
    // TextEncoder makes UTF-8 of any string.
    String::from_utf8_lossy(&bytes).into_owned()
}

#[unsafe(no_mangle)]
unsafe extern "C" fn database() {
    start();
    send_answer(&crate::database());
}

#[unsafe(no_mangle)]
unsafe extern "C" fn form(text: *mut u8, length: usize) {
    // SAFETY: JavaScript hands over what it took.
    let text = unsafe { taken(text, length) };
    send_answer(&crate::form(&text));
}

#[unsafe(no_mangle)]
unsafe extern "C" fn edit(text: *mut u8, length: usize, changes: *mut u8, n_changes: usize) {
    // SAFETY: JavaScript hands over what it took.
    let (text, changes) = unsafe { (taken(text, length), taken(changes, n_changes)) };
    match crate::edit(&text, &changes) {
        Ok(text) => send_answer(&json!({ "ok": true, "text": text })),
        Err(error) => send_answer(&Failure::from(error).json()),
    }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn check(text: *mut u8, length: usize) {
    // SAFETY: JavaScript hands over what it took.
    let text = unsafe { taken(text, length) };
    send_answer(&crate::check(&text));
}

#[unsafe(no_mangle)]
unsafe extern "C" fn solve(text: *mut u8, length: usize) {
    // SAFETY: JavaScript hands over what it took.
    let text = unsafe { taken(text, length) };
    let answer = crate::solve(&text, |event| {
        send(page::ertel_progress, &event.to_string())
    });
    send_answer(&answer);
}
