//! An allocator that counts what is asked of it.

// An allocator can be written in no other way; this one hands everything on to the system's.
#![allow(unsafe_code)]

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::sync::atomic::{AtomicUsize, Ordering};

thread_local! {
    static OWN: Cell<usize> = const { Cell::new(0) };
}
static ALL: AtomicUsize = AtomicUsize::new(0);

/// Allocations of this thread so far.
#[allow(dead_code)] // one test asks for these ...
pub fn of_this_thread() -> usize {
    OWN.with(Cell::get)
}

/// Allocations of all threads so far.
#[allow(dead_code)] // ... and one for those
pub fn of_all_threads() -> usize {
    ALL.load(Ordering::Relaxed)
}

fn count() {
    OWN.with(|own| own.set(own.get() + 1));
    ALL.fetch_add(1, Ordering::Relaxed);
}

struct Counting;

unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count();
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        unsafe { System.dealloc(pointer, layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        count();
        unsafe { System.realloc(pointer, layout, size) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;
