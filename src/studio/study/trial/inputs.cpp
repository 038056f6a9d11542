#include "base/archive.h"
#include "studio/study/trial/trial.h"

namespace muster {
namespace {

// Before the first input: kind and version of the bytes.
constexpr std::uint32_t kInputsVersion = 1;

template <class Archive, class Body>
void visitBody(Archive& archive, InputEvent& event) {
    if constexpr (Archive::kReading) {
        Body body;
        archive(body);
        event = body;
    } else {
        archive(std::get<Body>(event));
    }
}

template <class Archive>
void visitInput(Archive& archive, StampedInput& input) {
    auto kind = static_cast<std::uint8_t>(input.event.index());
    archive(input.step, kind);
    if (kind == 0) visitBody<Archive, PointerEvent>(archive, input.event);
    if (kind == 1) visitBody<Archive, KeyEvent>(archive, input.event);
    if (kind == 2) visitBody<Archive, GroundView>(archive, input.event);
    if constexpr (Archive::kReading) {
        if (kind > 2) archive.fail();
    }
}

}  // namespace

std::vector<std::uint8_t> encodeInputs(std::span<const StampedInput> inputs) {
    Writer writer;
    std::uint32_t version = kInputsVersion;
    auto count = static_cast<std::uint32_t>(inputs.size());
    writer(version, count);
    for (StampedInput input : inputs) visitInput(writer, input);
    return writer.take();
}

Result<std::vector<StampedInput>> decodeInputs(std::span<const std::uint8_t> bytes) {
    Reader reader(bytes);
    std::uint32_t version = 0;
    std::uint32_t count = 0;
    reader(version, count);
    if (!reader.ok() || version != kInputsVersion)
        return Status{StatusCode::ParseError, "found inputs of another version, expected version 1"};
    std::vector<StampedInput> inputs;
    for (std::uint32_t i = 0; i < count && reader.ok(); ++i) {
        StampedInput input;
        visitInput(reader, input);
        inputs.push_back(input);
    }
    if (!reader.ok() || reader.remaining() > 0)
        return Status{StatusCode::ParseError, "found inputs that are cut off or damaged"};
    return inputs;
}

}  // namespace muster
