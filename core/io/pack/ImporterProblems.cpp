#include "core/io/pack/ImporterProblems.h"

#include "core/base/MessageText.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

namespace rubble {
namespace {

constexpr std::size_t kBlenderName = 63;  // bytes
constexpr std::size_t kWindowsPath = 260, kFoldersAbove = 80;

Diagnostic problemOf(DiagnosticCode code, std::string message, std::size_t length, std::size_t limit) {
    return diagnostic(code, {}, std::move(message), static_cast<double>(length), static_cast<double>(limit));
}

/// A limit of engines on the corners of a hull.
struct CornerLimit {
    std::size_t corners;
    Severity severity;
    const char* consequence;
};

std::size_t mostCorners(const PackBody& body) {
    std::size_t corners = 0;
    for (const PackHull& hull : body.hulls) corners = std::max(corners, hull.polytope.vertices.size());
    return corners;
}

}  // namespace

std::vector<Diagnostic> surfaceNameProblems(std::span<const PackSurface> surfaces) {
    std::vector<Diagnostic> problems;
    for (const PackSurface& surface : surfaces) {
        const std::optional<std::string> effect = importerEffect(surface.name);
        if (!effect) continue;
        problems.push_back(diagnostic(DiagnosticCode::ImporterName, {},
                                      "Godot's importer acts on the end of the name of the material " +
                                          quotedName(surface.name) + " and " + *effect + "; rename it."));
    }
    return problems;
}

std::vector<Diagnostic> nameLengthProblems(const PackListing& pack) {
    std::vector<Diagnostic> problems;
    const std::size_t name = pack.folder.size() + std::string_view("_1").size();
    if (name > kBlenderName) {
        problems.push_back(problemOf(DiagnosticCode::LongName,
                                     "Blender cuts names at " + std::to_string(kBlenderName) +
                                         " bytes, which its fragments would share; give the asset a shorter name, or " +
                                         "export with --short-names.",
                                     name, kBlenderName));
    }
    const std::string& longest = *std::ranges::max_element(pack.files.names, {}, &std::string::size);
    const std::size_t path = pack.folder.size() + 1 + longest.size();
    if (path > kWindowsPath - kFoldersAbove) {
        problems.push_back(problemOf(DiagnosticCode::LongPath,
                                     "Its files have paths of " + std::to_string(path) +
                                         " bytes within the export, and Windows opens paths of " +
                                         std::to_string(kWindowsPath) +
                                         " at most; give the asset a shorter name, or export with --short-names.",
                                     path, kWindowsPath - kFoldersAbove));
    }
    return problems;
}

std::vector<Diagnostic> hullCornerProblems(const Pack& pack) {
    constexpr CornerLimit kLimits[] = {
        {255, Severity::Warning, "PhysX, and with it Unity and Unreal, takes no more than 255"},
        {64, Severity::Note, "PhysX simulates those above 64 on the processor only"},
    };
    const PackBody* worst = &pack.whole;
    for (const PackBody& body : pack.fragments) {
        if (mostCorners(body) > mostCorners(*worst)) worst = &body;
    }
    const std::size_t corners = mostCorners(*worst);
    for (const CornerLimit& limit : kLimits) {
        if (corners <= limit.corners) continue;
        Diagnostic problem = problemOf(DiagnosticCode::ManyHullCorners,
                                       "A hull of " + quotedName(worst->name) + " has " + std::to_string(corners) +
                                           " corners: " + limit.consequence + ".",
                                       corners, limit.corners);
        problem.severity = limit.severity;
        return {std::move(problem)};
    }
    return {};
}

}  // namespace rubble
