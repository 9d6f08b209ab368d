#pragma once

#include "core/geometry/polygon/Polygon.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <string>
#include <vector>

namespace rubble::test {

/// An outline and its seeds, from a file of test data.
struct SeededOutline {
    std::string name;
    Polygon outline;
    std::vector<Vec2> seeds;
};

inline QJsonObject readJson(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) return {};
    return QJsonDocument::fromJson(file.readAll()).object();
}

inline std::vector<Vec2> pointsOf(const QJsonValue& array) {
    std::vector<Vec2> points;
    for (const QJsonValue point : array.toArray()) points.emplace_back(point[0].toDouble(), point[1].toDouble());
    return points;
}

/// Reads the keys `outline`, `holes` and `seeds`.
inline SeededOutline seededOutline(const QJsonObject& object) {
    SeededOutline result;
    result.name = object["name"].toString().toStdString();
    result.outline.outer = pointsOf(object["outline"]);
    for (const QJsonValue hole : object["holes"].toArray()) result.outline.holes.push_back(pointsOf(hole));
    result.seeds = pointsOf(object["seeds"]);
    return result;
}

/// A small case in which the reference method is wrong, with the exact result.
struct Counterexample : SeededOutline {
    std::vector<double> areas;                           // m², by seed
    std::vector<std::vector<std::uint32_t>> neighbours;  // by seed, ascending
};

inline std::vector<Counterexample> counterexamples() {
    std::vector<Counterexample> cases;
    const QJsonObject file = readJson(RUBBLE_SOURCE_DIR "/tests/data/thesis-counterexamples.json");
    for (const QJsonValue value : file["cases"].toArray()) {
        Counterexample example{seededOutline(value.toObject()), {}, {}};
        for (const QJsonValue area : value["areas"].toArray()) example.areas.push_back(area.toDouble());
        for (const QJsonValue list : value["neighbours"].toArray()) {
            example.neighbours.emplace_back();
            for (const QJsonValue neighbour : list.toArray())
                example.neighbours.back().push_back(static_cast<std::uint32_t>(neighbour.toInt()));
        }
        cases.push_back(std::move(example));
    }
    return cases;
}

}  // namespace rubble::test
