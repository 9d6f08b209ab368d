#pragma once

#include "core/io/project/ProjectJournal.h"
#include "editor/document/Edit.h"

#include <map>
#include <set>
#include <utility>

namespace rubble {

/// What has changed in a project since it was last recorded, by its elements: noting an edit copies no values.
class UnrecordedEdits {
public:
    void note(const Changes& changes);
    bool isEmpty() const { return m_elements.empty() && !m_isEverything; }
    /// The project was replaced: a record cannot express that.
    bool isEverything() const { return m_isEverything; }
    /// The project was written as a whole.
    void forget(const Project& project);
    /// Returns the elements that changed as they are now; they count as recorded.
    ProjectPart take(const Project& project);

private:
    std::set<std::pair<Part, Id>> m_elements;
    std::map<Id, Texture> m_textures;  // of assets, as recorded
    bool m_isEverything = false;
};

}  // namespace rubble
