#pragma once

#include "core/fracture/GreyImage.h"

#include <QWidget>

#include <memory>

class QLabel;
class QPushButton;

namespace rubble {

/// A grey picture as a thumbnail, with a button by which another one is chosen among files.
class PictureField : public QWidget {
    Q_OBJECT
public:
    using Picture = std::shared_ptr<const GreyImage>;

    explicit PictureField(QWidget* parent = nullptr);
    /// Null for none.
    void setPicture(const Picture& picture);
    /// Takes a picture from a file, as if it was chosen.
    void load(const QString& path);

signals:
    void chosen(rubble::PictureField::Picture picture);
    /// What is wrong with a file.
    void refused(const QString& sentence);

private:
    void choose();

    Picture m_picture;
    QLabel* m_thumbnail;
    QLabel* m_text;
    QPushButton* m_choose;
};

}  // namespace rubble
