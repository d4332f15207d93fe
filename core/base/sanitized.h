// STILLCUT_SANITIZED_ADDRESSES, STILLCUT_SANITIZED_THREADS: defined where that sanitizer is at work, for the little
// that it does itself or forbids (its own allocator, its vast address space). GCC and clang tell it by different names.
#pragma once

#ifdef __has_feature
#if __has_feature(address_sanitizer)
#define STILLCUT_SANITIZED_ADDRESSES
#endif
#if __has_feature(thread_sanitizer)
#define STILLCUT_SANITIZED_THREADS
#endif
#endif

#ifdef __SANITIZE_ADDRESS__
#define STILLCUT_SANITIZED_ADDRESSES
#endif
#ifdef __SANITIZE_THREAD__
#define STILLCUT_SANITIZED_THREADS
#endif
