#include "muster/experiments/reproduce.h"

namespace muster {

std::string reportHtml(const Reproduction&) { return "<!doctype html>"; }
std::string summaryMarkdown(const Reproduction&) { return ""; }

}  // namespace muster
