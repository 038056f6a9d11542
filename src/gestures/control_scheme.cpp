#include "gestures/control_scheme.h"

namespace muster {
namespace {

// Does nothing.
class NoScheme final : public ControlScheme {
public:
    void input(const InputEvent&, const World&, std::vector<CommandBody>&) override {}
    void beforeStep(const World&, std::vector<CommandBody>&) override {}
    const SchemeMarks& marks() const override { return marks_; }
    bool busy() const override { return false; }

private:
    SchemeMarks marks_;
};

}  // namespace

std::unique_ptr<ControlScheme> makeControlScheme(const SchemeDef&) {
    return std::make_unique<NoScheme>();
}

}  // namespace muster
