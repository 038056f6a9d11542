#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

#include <cerrno>
#include <cstring>

#include "files/take/take_encoder.h"
#include "files/take/take_frames.h"
#include "muster/take.h"

namespace muster {
namespace {

/// Brings what was written to the disk; true also for files that have none behind them.
bool synchronise(std::FILE* file) {
#ifdef _WIN32
    return std::fflush(file) == 0 && _commit(_fileno(file)) == 0;
#else
    return fsync(fileno(file)) == 0 || errno == EINVAL || errno == ENOTSUP;
#endif
}

}  // namespace

void TakeWriter::CloseFile::operator()(std::FILE* file) const {
    std::fclose(file);
}

TakeWriter::TakeWriter(std::FILE* file, std::string path)
    : file_(file), path_(std::move(path)), frames_(std::make_unique<FrameRecorder>()) {}
TakeWriter::TakeWriter(TakeWriter&&) noexcept = default;
TakeWriter& TakeWriter::operator=(TakeWriter&&) noexcept = default;
TakeWriter::~TakeWriter() = default;

Result<TakeWriter> TakeWriter::create(const std::string& path, const WorldDef& def, bool overwrite) {
    std::FILE* file = std::fopen(path.c_str(), overwrite ? "wb" : "wbx");
    if (file == nullptr) {
        return Status(StatusCode::IoError, path + ": cannot be written: " + std::strerror(errno));
    }
    TakeWriter writer(file, path);
    if (Status s = writer.append(TakeEncoder::begin(def)); !s.ok()) return s;
    return writer;
}

Status TakeWriter::append(const std::vector<std::uint8_t>& bytes) {
    if (!file_) return {StatusCode::IoError, path_ + ": the take is finished already"};
    const bool wrote = std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) == bytes.size();
    if (wrote && std::fflush(file_.get()) == 0) return {};
    return {StatusCode::IoError, path_ + ": cannot be written: " + std::strerror(errno)};
}

Status TakeWriter::command(const Command& command) {
    return append(TakeEncoder::command(command));
}

Status TakeWriter::observe(const World& world) {
    if (const auto events = TakeEncoder::events(world); !events.empty())
        if (Status s = append(events); !s.ok()) return s;
    if (frames_->observe(world))
        if (Status s = append(TakeEncoder::frames(frames_->take())); !s.ok()) return s;
    if (world.stepCount() % kTakeMarkSpacing != 0) return {};
    return append(TakeEncoder::mark({world.stepCount(), world.hash()}));
}

Status TakeWriter::finish(const World& world) {
    if (Status s = append(TakeEncoder::frames(frames_->take())); !s.ok()) return s;
    if (Status s = append(TakeEncoder::end({world.stepCount(), world.hash()})); !s.ok()) return s;
    const bool synced = synchronise(file_.get());
    const bool closed = std::fclose(file_.release()) == 0;
    if (synced && closed) return {};
    return {StatusCode::IoError, path_ + ": cannot be brought to the disk: " + std::strerror(errno)};
}

}  // namespace muster
