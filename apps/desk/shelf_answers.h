// Answers to requests to the shelf of takes.
#pragma once

#include <functional>
#include <string>

#include "http_answer.h"
#include "shelf_request.h"
#include "take_shelf.h"

namespace muster {

/// The shelf's answers to all requests but those that open a take or are about exports, which others answer.
class ShelfAnswers {
public:
    /// Tells the session what is said about a take now.
    using TakeEdited = std::function<void(std::string name, TakeAbout about)>;

    /// The shelf must outlive this.
    ShelfAnswers(TakeShelf& shelf, TakeEdited edited);

    /// The answer; 404 for requests that others answer.
    HttpAnswer answer(const ShelfRequest& request);

private:
    HttpAnswer edit(const ShelfRequest& request);

    TakeShelf& shelf_;
    TakeEdited edited_;
};

}  // namespace muster
