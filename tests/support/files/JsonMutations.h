#pragma once

#include "tests/support/files/Schemas.h"

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace rubble::test {

/// A document with one error, and its expected path.
struct JsonMutation {
    std::string name;   // of the mutation, for messages
    std::string place;  // "assets[2].prism.depth", as error messages start
    nlohmann::json document;
};

namespace mutation {

using Json = nlohmann::json;

inline std::string placeOf(const Json::json_pointer& pointer, const Json& root) {
    std::string place;
    Json::json_pointer parent;
    std::vector<std::string> steps;
    for (Json::json_pointer rest = pointer; !rest.empty(); rest.pop_back()) steps.insert(steps.begin(), rest.back());
    for (const std::string& step : steps) {
        if (root.at(parent).is_array()) {
            place += "[" + step + "]";
        } else {
            place += (place.empty() ? "" : ".") + step;
        }
        parent.push_back(step);
    }
    return place.empty() ? "The document" : place;
}

/// Values of every type except the current one.
inline std::vector<Json> otherTypes(const Json& value) {
    std::vector<Json> wrong;
    if (!value.is_null()) wrong.push_back(nullptr);
    if (!value.is_boolean()) wrong.push_back(true);
    if (!value.is_string()) wrong.push_back("word");
    if (!value.is_number()) wrong.push_back(1.5);
    if (!value.is_object()) wrong.push_back(Json::object());
    if (!value.is_array()) wrong.push_back(Json::array({Json::array()}));
    return wrong;
}

inline void forEachPlace(const Json& value, Json::json_pointer at,
                         const std::function<void(const Json&, const Json::json_pointer&)>& visit) {
    visit(value, at);
    if (value.is_object())
        for (const auto& [key, child] : value.items()) forEachPlace(child, at / key, visit);
    if (value.is_array())
        for (std::size_t k = 0; k < value.size(); ++k) forEachPlace(value[k], at / k, visit);
}

/// Returns whether an array holds objects.
inline bool holdsObjects(const Json& value) { return value.is_array() && !value.empty() && value.front().is_object(); }

/// Returns a value with its arrays of objects emptied.
inline Json bare(const Json& value) {
    if (holdsObjects(value)) return Json::array();
    if (!value.is_object()) return value;
    Json less = Json::object();
    for (const auto& [key, child] : value.items()) less[key] = bare(child);
    return less;
}

/// A document and a position in it.
struct Placed {
    Json document;
    Json::json_pointer at;
};

/// Returns the same position in a reduced document, whose arrays hold only the elements on the way to it.
inline Placed around(const Json& value, std::vector<std::string> steps) {
    if (steps.empty()) return {value, Json::json_pointer()};
    const std::string step = steps.back();
    steps.pop_back();
    const std::size_t index = value.is_array() ? std::stoul(step) : 0;
    Placed inner = around(value.is_array() ? value[index] : value[step], std::move(steps));
    Placed outer;
    if (holdsObjects(value)) {
        outer = {Json::array({std::move(inner.document)}), Json::json_pointer() / std::size_t{0}};
    } else if (value.is_array()) {
        outer = {value, Json::json_pointer() / index};
        outer.document[index] = std::move(inner.document);
    } else {
        outer = {bare(value), Json::json_pointer() / step};
        outer.document[step] = std::move(inner.document);
    }
    outer.at /= inner.at;
    return outer;
}

inline Placed around(const Json& document, Json::json_pointer at) {
    std::vector<std::string> steps;
    for (; !at.empty(); at.pop_back()) steps.push_back(at.back());
    return around(document, std::move(steps));
}

/// The key that is added to objects.
inline const std::string kAddedKey = "colour scheme";

/// Calls visit(at, what, value) for each mutation: every value replaced by one of every other type, every key removed,
/// and a key added to every object. Skips values for which `fits` is true; a discarded one stands for a missing key.
inline void forEachMutation(
    const Json& document, const std::function<bool(const std::string& place, const Json& value)>& fits,
    const std::function<void(const Json::json_pointer& at, const std::string& what, Json value)>& visit) {
    forEachPlace(document, Json::json_pointer(), [&](const Json& value, const Json::json_pointer& at) {
        const std::string place = placeOf(at, document);
        for (const Json& other : otherTypes(value)) {
            if (!fits(place, other)) visit(at, " = " + other.dump(), other);
        }
        if (!value.is_object()) return;
        for (const auto& item : value.items()) {
            if (fits(placeOf(at / item.key(), document), Json(Json::value_t::discarded))) continue;
            Json less = value;
            less.erase(item.key());
            visit(at, " without " + item.key(), std::move(less));
        }
        if (fits(placeOf(at / kAddedKey, document), 1)) return;
        Json more = value;
        more[kAddedKey] = 1;
        visit(at, " with one more key", std::move(more));
    });
}

}  // namespace mutation

/// Returns the documents of all mutations.
inline std::vector<JsonMutation> mutationsOf(
    const nlohmann::json& document,
    const std::function<bool(const std::string& place, const nlohmann::json& value)>& fits) {
    std::vector<JsonMutation> mutations;
    mutation::forEachMutation(document, fits, [&](const auto& at, const std::string& what, nlohmann::json value) {
        nlohmann::json changed = document;
        changed[at] = std::move(value);
        mutations.push_back({at.to_string() + what, mutation::placeOf(at, document), std::move(changed)});
    });
    return mutations;
}

/// Returns the text of a document with another value at a position.
inline std::string changedText(nlohmann::json document, const std::string& pointer, const std::string& value) {
    document[nlohmann::json::json_pointer(pointer)] = nlohmann::json::parse(value);
    return document.dump();
}

/// Returns the mutations of a document that its reader or its schema accepts, or reports with another path; empty if
/// all is well. `faultOf` reads a text and returns its error. It gets the whole document; the schema gets a reduced
/// one, because validation is slow and none of our schemas relates elements of an array. `isOpen`: places that the
/// schema leaves to the reader; none if null.
inline std::string unreportedMutation(
    const nlohmann::json& document, const Schema& schema,
    const std::function<bool(const std::string& place, const nlohmann::json& value)>& fits,
    const std::function<std::string(std::string_view)>& faultOf,
    const std::function<bool(const std::string& place)>& isOpen = nullptr) {
    nlohmann::json changed = document;
    nlohmann::json::json_pointer last;
    mutation::Placed near{document, last};
    std::string unreported;
    mutation::forEachMutation(document, fits, [&](const auto& at, const std::string& what, nlohmann::json value) {
        if (!unreported.empty()) return;
        if (at != last) {
            near = mutation::around(document, last = at);
            if (!schema.fault(near.document).empty()) near = {document, at};  // an array must not be that short
        }
        std::swap(changed[at], value);
        const std::string fault = faultOf(changed.dump());
        near.document[near.at] = changed[at];
        const std::string place = mutation::placeOf(at, document);
        if (!fault.starts_with(place + ": ")) {
            unreported = at.to_string() + what + " gives: " + fault;
        } else if (!(isOpen && isOpen(place)) && schema.fault(near.document).empty()) {
            unreported = at.to_string() + what + " fits the schema";
        }
        std::swap(changed[at], value);
    });
    return unreported;
}

}  // namespace rubble::test
