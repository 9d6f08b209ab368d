#pragma once

#include "editor/dialogs/OutputPath.h"
#include "viewport/scene/Camera.h"

#include <QDialog>
#include <QString>

#include <vector>

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace rubble {

/// A view of which a picture can be saved.
struct PictureView {
    QString title;
    ImageSize size;         // on screen
    bool isCanvas = false;  // otherwise the 3D view
};

/// The views that a picture can show, and defaults.
struct PictureSubject {
    std::vector<PictureView> views;  // at least one
    int view = 0;                    // the index of the view in focus
    OutputDefaults defaults;         // of the file, if no picture was saved before
};

struct PictureTarget {
    QString path;  // with its suffix
    ImageSize size;
    bool isCanvas = false;
};

/// Asks for the view, the size and the file of a picture. Starts with the size, the format and the folder of the last
/// one.
class PictureDialog : public QDialog {
    Q_OBJECT
public:
    PictureDialog(const PictureSubject& subject, QWidget* parent);
    PictureTarget options() const;

    void accept() override;

private:
    const PictureView& selectedView() const;
    void addFields(QFormLayout& form);
    void restoreOptions();
    void browse();
    void updateSizes();
    void updateSummary();
    QString error() const;

    PictureSubject m_subject;
    QLineEdit* m_path;
    QComboBox* m_view;
    QComboBox* m_size;
    QLabel* m_summary;
    QPushButton* m_save = nullptr;
};

}  // namespace rubble
