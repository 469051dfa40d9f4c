#pragma once

/// 1 where this is built with the address or the thread sanitizer, else 0.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define ONGGI_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define ONGGI_SANITIZED 1
#endif
#endif
#ifndef ONGGI_SANITIZED
#define ONGGI_SANITIZED 0
#endif
