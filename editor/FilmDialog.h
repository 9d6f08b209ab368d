#pragma once

#include "viewport/scene/Camera.h"

#include <QDialog>
#include <QString>

#include <cstdint>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace rubble {

/// What there is to be filmed.
struct FilmSubject {
    QString name;              // of the project, without folders: files are called after it
    QString folder;            // where they go unless the last film went elsewhere
    std::uint64_t length = 0;  // steps
    double stepLength = 0.0;   // s
    double speed = 1.0;        // at which it was watched
};

/// How it is filmed.
struct FilmChoice {
    QString place;  // a film with its suffix, or the folder of its pictures
    bool isFilm = false;
    PictureSize size;
    int samples = 0;  // see FilmPlan
    double rate = 30.0;
    double speed = 1.0;  // 1: as fast as the play
    std::uint64_t first = 0, last = 0;
    bool isCompared = false;
    /// Steps from picture to picture.
    double every(double stepLength) const { return speed / (rate * stepLength); }
};

/// Asks how a play is filmed, and says how many pictures that makes. Begins with what was chosen last.
class FilmDialog : public QDialog {
    Q_OBJECT
public:
    FilmDialog(const FilmSubject& subject, QWidget* parent);
    FilmChoice choice() const;

    void accept() override;

private:
    void makePlace(QFormLayout& form);
    void makePictures(QFormLayout& form);
    void makeTime(QFormLayout& form);
    void fill();
    void takeKind();
    void browse();
    void update();
    QString fault(const FilmChoice& choice, int pictures) const;
    QString summary(const FilmChoice& choice, int pictures) const;

    FilmSubject m_subject;
    bool m_hasFfmpeg;
    QComboBox* m_kind;
    QLineEdit* m_place;
    QSpinBox* m_width;
    QSpinBox* m_height;
    QComboBox* m_quality;
    QCheckBox* m_compare;
    QDoubleSpinBox* m_rate;
    QDoubleSpinBox* m_speed;
    QSpinBox* m_first;
    QSpinBox* m_last;
    QLabel* m_summary;
    QPushButton* m_export = nullptr;
};

}  // namespace rubble
