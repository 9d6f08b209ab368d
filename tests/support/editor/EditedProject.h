#pragma once

#include "core/asset/checks/VerifyProject.h"
#include "core/io/project/ProjectFile.h"
#include "editor/document/Document.h"

#include <QTest>

#include <utility>

namespace rubble::test {

/// The project after an edit, which must be valid; undoing the edit must restore the bytes. Otherwise the test fails,
/// and the project is empty.
inline Project editedProject(const Project& project, Edit edit) {
    Document document(project);
    document.push(std::move(edit));
    const Project edited = document.project();
    const auto failed = [](const char* message) {
        QTest::qFail(message, __FILE__, __LINE__);
        return Project{};
    };
    if (const auto fault = verifyProject(edited)) return failed(fault->c_str());
    document.undoStack().undo();
    if (projectText(document.project()) != projectText(project)) return failed("Undoing gives another project.");
    return edited;
}

}  // namespace rubble::test
