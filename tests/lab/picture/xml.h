// A strict reader of the part of XML that pictures use; it rejects documents that are not well-formed.
#pragma once

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

namespace muster::testing {

/// An element with its contents.
struct Element {
    std::string name;
    std::map<std::string, std::string> attributes;
    std::string text;  ///< Text directly inside the element.
    int depth = 0;     ///< 0 for the root.

    double number(const std::string& attribute) const {
        const auto found = attributes.find(attribute);
        return found == attributes.end() ? -1e9 : std::strtod(found->second.c_str(), nullptr);
    }
    std::string attribute(const std::string& key) const {
        const auto found = attributes.find(key);
        return found == attributes.end() ? "" : found->second;
    }
};

/// Parses a whole document; `error` is empty where it is well-formed.
class XmlReader {
public:
    explicit XmlReader(const std::string& document) : document_(document) {
        while (error.empty() && at_ < document_.size()) piece();
        if (error.empty() && !open_.empty()) error = "not closed: " + elements[open_.back()].name;
        if (error.empty() && elements.empty()) error = "no element";
    }

    std::vector<Element> elements;  ///< In the order of their opening tags.
    std::string error;

    /// All elements with that name.
    std::vector<Element> all(const std::string& name) const {
        std::vector<Element> found;
        for (const Element& element : elements) {
            if (element.name == name) found.push_back(element);
        }
        return found;
    }

private:
    void piece() {
        if (document_[at_] != '<') return words();
        if (document_.compare(at_, 2, "</") == 0) return close();
        begin();
    }
    void words() {
        const std::size_t end = std::min(document_.find('<', at_), document_.size());
        const std::string text = decoded(document_.substr(at_, end - at_));
        const bool blank = text.find_first_not_of(" \n\t") == std::string::npos;
        if (!open_.empty())
            elements[open_.back()].text += text;
        else if (!blank)
            error = "text outside the root";
        at_ = end;
    }
    void close() {
        const std::size_t end = document_.find('>', at_);
        if (end == std::string::npos || open_.empty() ||
            document_.substr(at_ + 2, end - at_ - 2) != elements[open_.back()].name) {
            error = "closing tag that closes nothing";
            return;
        }
        open_.pop_back();
        at_ = end + 1;
    }
    void begin() {
        if (open_.empty() && !elements.empty()) error = "two roots";
        ++at_;
        Element element{.name = word()};
        if (element.name.empty()) error = "no name";
        element.depth = static_cast<int>(open_.size());
        while (error.empty() && document_.compare(at_, 1, " ") == 0) attribute(element);
        elements.push_back(element);
        if (document_.compare(at_, 2, "/>") == 0) {
            at_ += 2;
        } else if (document_.compare(at_, 1, ">") == 0) {
            at_ += 1;
            open_.push_back(elements.size() - 1);
        } else if (error.empty()) {
            error = "tag without an end: " + element.name;
        }
    }
    void attribute(Element& element) {
        ++at_;
        const std::string name = word();
        const std::size_t end = document_.find('"', at_ + 2);
        if (name.empty() || document_.compare(at_, 2, "=\"") != 0 || end == std::string::npos) {
            error = "bad attribute of " + element.name;
            return;
        }
        const std::string value = document_.substr(at_ + 2, end - at_ - 2);
        if (value.find('<') != std::string::npos) error = "bare < in " + name;
        if (!element.attributes.emplace(name, decoded(value)).second)
            error = "attribute given twice: " + name;
        at_ = end + 1;
    }
    std::string word() {
        const std::size_t from = at_;
        while (at_ < document_.size() &&
               (std::isalnum(static_cast<unsigned char>(document_[at_])) != 0 || document_[at_] == '-'))
            ++at_;
        return document_.substr(from, at_ - from);
    }
    std::string decoded(const std::string& raw) {
        std::string text;
        for (std::size_t i = 0; i < raw.size(); ++i) {
            if (raw[i] != '&') {
                text += raw[i];
                continue;
            }
            const std::size_t end = raw.find(';', i);
            const std::string entity = end == std::string::npos ? "" : raw.substr(i + 1, end - i - 1);
            if (entity == "lt")
                text += '<';
            else if (entity == "gt")
                text += '>';
            else if (entity == "amp")
                text += '&';
            else if (entity == "quot")
                text += '"';
            else
                error = "bare & or unknown entity";
            i = end == std::string::npos ? raw.size() : end;
        }
        return text;
    }

    const std::string& document_;
    std::size_t at_ = 0;
    std::vector<std::size_t> open_;
};

}  // namespace muster::testing
