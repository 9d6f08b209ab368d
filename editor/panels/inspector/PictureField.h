#pragma once

#include "core/fracture/sampling/GreyImage.h"

#include <QWidget>

#include <memory>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace rubble {

/// A thumbnail of a greyscale picture with a button that loads another one.
class PictureField : public QWidget {
    Q_OBJECT
public:
    using Picture = std::shared_ptr<const GreyImage>;

    explicit PictureField(QWidget* parent = nullptr);
    /// Null: no picture.
    void setPicture(const Picture& picture);
    /// Adds a button that removes the picture, shown while there is one.
    void setClearable();
    /// Loads a file in the background, shows its progress, and emits `picked`, or `refused`.
    void load(const QString& path);

signals:
    void picked(rubble::PictureField::Picture picture);
    /// The button that removes the picture was clicked.
    void cleared();
    /// A file could not be loaded; the sentence says why.
    void refused(const QString& sentence);
    /// A picture that was loaded is smaller than its file.
    void reduced(const QString& sentence);

private:
    void openDialog();

    Picture m_picture;
    QVBoxLayout* m_beside;
    QLabel* m_thumbnail;
    QLabel* m_text;
    QPushButton* m_open;
    QPushButton* m_clear = nullptr;
};

}  // namespace rubble
