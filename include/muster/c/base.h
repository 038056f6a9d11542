/* Made by schema/generate.mjs from schema/api/base.txt: change these, not this file. */
/* What all parts of the C API share: codes of failures, their sentences, memory, log, threads. C99 and
 * C++. */
#ifndef MUSTER_C_BASE_H
#define MUSTER_C_BASE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#if defined(MUSTER_BUILDING) && defined(_WIN32)
#define MUSTER_API __declspec(dllexport)
#elif defined(MUSTER_SHARED) && defined(_WIN32)
#define MUSTER_API __declspec(dllimport)
#elif defined(__GNUC__)
#define MUSTER_API __attribute__((visibility("default")))
#else
#define MUSTER_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/// What kind of thing went wrong.
typedef int32_t MusterStatus;
/// Values of MusterStatus.
enum MusterStatusValue {
    MUSTER_OK = 0,                ///< Success.
    MUSTER_INVALID_ARGUMENT = 1,  ///< A value is outside its range or contradicts another.
    MUSTER_NOT_FOUND = 2,         ///< No object has this name or id; also for a handle that was destroyed.
    MUSTER_PARSE_ERROR = 3,       ///< Text or bytes that do not follow the format.
    MUSTER_IO_ERROR = 4,          ///< A file that cannot be read or written.
    MUSTER_CORRUPT = 5,           ///< A checksum or hash that does not match.
    MUSTER_UNSUPPORTED = 6,       ///< Valid, but of a version or kind not known here.
    MUSTER_LIMIT_EXCEEDED = 7,    ///< Too large, too many, too often.
    MUSTER_OUT_OF_MEMORY = 8,     ///< Memory could not be had.
    MUSTER_INTERNAL = 9           ///< A fault of Muster itself.
};

/// The sentence of this thread's last call that failed: the same as that of the C++ API, without a trailing
/// newline. Calls that succeed do not change it. Empty before the first failure. Valid until the next failure
/// in this thread.
MUSTER_API const char* muster_last_error(void);
/// The name of a code: "ok", "invalid argument"... "unknown" for other numbers.
MUSTER_API const char* muster_status_name(MusterStatus status);

/// The version of the library, "MAJOR.MINOR.PATCH".
MUSTER_API const char* muster_version(void);
/// True where the library was built with that component: "core", "motion" or "io". Null is none.
MUSTER_API bool muster_has_component(const char* component);

/// Memory of the host. Both functions may be called from any thread.
typedef struct MusterAllocator {
    void* context;  ///< Passed unchanged as the first argument. May be null.
    /// Gives `size` bytes at a multiple of `alignment`, a power of two, or null. Must not be null.
    void* (*allocate)(void* context, size_t size, size_t alignment);
    /// Takes back what `allocate` gave. Must not be null.
    void (*release)(void* context, void* memory);
} MusterAllocator;

/// Takes memory from the host from now on; null for the standard functions again. What was allocated before
/// goes back to where it came from, so the functions must work until all of their memory is released. What
/// comes from here is stated by muster_allocator_covers_engine(). Fails with InvalidArgument where a function
/// is null.
MUSTER_API MusterStatus muster_set_allocator(const MusterAllocator* allocator);

/// True where all that the library takes with C++ `new` comes from the allocator (a shared library that was
/// built with MUSTER_HOST_ALLOCATOR). False: only the memory that the C API itself takes for read-outs,
/// buffers and text.
MUSTER_API bool muster_allocator_covers_engine(void);

/// Kinds of log messages.
typedef int32_t MusterLogLevel;
/// Values of MusterLogLevel.
enum MusterLogLevelValue {
    MUSTER_LOG_INFO = 0,    ///< Something that is good to know, as a command that was refused in its step.
    MUSTER_LOG_FAILURE = 1  ///< A call failed; the text is its sentence.
};

/// Gets a message: one sentence, valid during the call. It may come from any thread that calls the library.
/// It must not call the library.
typedef void (*MusterLogFunction)(void* context, MusterLogLevel level, const char* message);
/// Sends messages to a function from now on; null for none, as at first. The library itself prints nothing.
MUSTER_API void muster_set_log(MusterLogFunction function, void* context);

/// Bytes that belong to the caller until muster_free_buffer(). A zero byte follows them, so text can be used
/// as it is.
typedef struct MusterBuffer {
    uint8_t* data;  ///< The bytes; null where there are none.
    size_t size;    ///< Their number, without the zero byte.
} MusterBuffer;

/// Releases the bytes and sets the buffer to none. Null, and a buffer without bytes, are fine.
MUSTER_API void muster_free_buffer(MusterBuffer* buffer);

/// A piece of work that is called once for each of its items.
typedef void (*MusterTask)(void* taskContext, int32_t item, int32_t worker);
/// A long piece of work for the background.
typedef void (*MusterBackgroundTask)(void* taskContext);

/// The job system of the host, in place of the library's own threads. Results are the same.
typedef struct MusterTaskRunner {
    uint32_t structVersion;  ///< Set by muster_default_task_runner().
    int32_t threads;         ///< Largest number of workers that run at the same time, the calling thread
                             ///< included where it takes part [1 to 256].
    void* context;           ///< Passed unchanged as the first argument of each function below. May be null.
    /// Calls `task(taskContext, item, worker)` once for every item in [0, count), in any order and on any
    /// threads. Returns when all calls have returned and their writes are visible to the calling thread.
    /// `worker` lies in [0, threads); no two simultaneous calls have the same `worker`. Must not be null.
    void (*run)(void* context, int32_t count, MusterTask task, void* taskContext);
    /// Starts `task(taskContext)` on another thread, now or later, and returns at once. Null if the host has
    /// no thread for background work, which is then done in the calling thread.
    void (*launch)(void* context, MusterBackgroundTask task, void* taskContext);
    /// Returns when the launched task has returned and its writes are visible to the calling thread. Must not
    /// be null if `launch` is not.
    void (*wait)(void* context);
} MusterTaskRunner;

/// One thread, no functions.
MUSTER_API MusterTaskRunner muster_default_task_runner(void);

#ifdef __cplusplus
}
#endif

#endif
