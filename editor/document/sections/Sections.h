#pragma once

#include "core/asset/project/Project.h"

#include <QObject>

#include <map>

namespace rubble {

/// Where a mesh is cut to show its cells in a plane.
struct SectionView {
    int axis = 2;           // 0, 1, 2: the plane is perpendicular to x, y, z
    double position = 0.5;  // 0 to 1: from the lowest to the highest point of the mesh along the axis
    bool operator==(const SectionView&) const = default;
};

/// The sections that one window shows of meshes: one for each asset.
class Sections : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    SectionView of(Id asset) const;
    /// The position is clamped.
    void set(Id asset, SectionView view);

signals:
    void changed(rubble::Id asset);

private:
    std::map<Id, SectionView> m_views;  // those that are not the default
};

}  // namespace rubble
