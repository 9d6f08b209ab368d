#pragma once

#include "core/fracture/planes/SolidSection.h"
#include "editor/document/Bakes.h"
#include "editor/document/Selection.h"
#include "editor/document/sections/Sections.h"

#include <QObject>

#include <memory>

namespace rubble {

/// Keeps the pattern of the active asset, if it is a mesh, up to date: that of its section, or of the section of the
/// entered fragment. Made at once, also while a section is dragged.
class SectionUpdater : public QObject {
    Q_OBJECT
public:
    SectionUpdater(const Selection& selection, const Sections& sections, Bakes& bakes, QObject* parent = nullptr);

private:
    /// What the slicer was made for.
    struct Key {
        std::shared_ptr<const Bake> bake;
        std::uint32_t parent = kNone;
        int axis = 2;
        bool operator==(const Key&) const = default;
    };
    void refresh();

    const Selection& m_selection;
    const Sections& m_sections;
    Bakes& m_bakes;
    Key m_key;
    std::unique_ptr<const SolidSlicer> m_slicer;  // of m_key
};

}  // namespace rubble
