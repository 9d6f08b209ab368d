#pragma once

#include <QList>
#include <QObject>

class QAction;

namespace rubble {

class MaterialPictures;
class Views;

/// The actions on the material library, for the Asset menu, the project tree and the inspector.
class MaterialActions : public QObject {
    Q_OBJECT
public:
    explicit MaterialActions(Views& views);

    QAction* library() const { return m_library; }
    /// Saves the selected material as a preset, or that of the active asset if no material is selected.
    QAction* save() const { return m_save; }
    QList<QAction*> actions() const { return {m_library, m_save}; }

private:
    void openLibrary();
    void saveAsPreset();

    Views& m_views;
    MaterialPictures* m_pictures;  // of the library
    QAction* m_library = nullptr;
    QAction* m_save = nullptr;
};

}  // namespace rubble
