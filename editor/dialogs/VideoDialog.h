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

/// The recorded simulation that is to be exported.
struct VideoSubject {
    QString name;              // of the project; the default file name
    QString folder;            // the default folder, if no video was exported before
    std::uint64_t length = 0;  // steps
    double stepLength = 0.0;   // s
    double speed = 1.0;        // the playback speed
};

struct VideoOptions {
    QString path;          // of a video with its suffix, or of the folder of its images
    bool isVideo = false;  // otherwise a sequence of images
    ImageSize size;
    int samples = 0;                    // see VideoPlan
    double frameRate = 30.0;            // frames per second
    double speed = 1.0;                 // 1: real time
    std::uint64_t first = 0, last = 0;  // steps
    bool isCompared = false;            // beside a simulation without destruction
    /// Simulation steps from one frame to the next.
    double stepsPerFrame(double stepLength) const { return speed / (frameRate * stepLength); }
};

/// Asks how to export a video, and shows how many frames it will have. Starts with the options of the last video.
class VideoDialog : public QDialog {
    Q_OBJECT
public:
    VideoDialog(const VideoSubject& subject, QWidget* parent);
    VideoOptions options() const;

    void accept() override;

private:
    void addTarget(QFormLayout& form);
    void addFrames(QFormLayout& form);
    void addTime(QFormLayout& form);
    void addButtons(QFormLayout& form);
    void connectFields();
    void restoreOptions();
    void updateSuffix();
    void browse();
    void updateSummary();
    QString error(const VideoOptions& options, int frames) const;
    QString summary(const VideoOptions& options, int frames) const;

    VideoSubject m_subject;
    bool m_hasFfmpeg;
    QComboBox* m_kind;
    QLineEdit* m_path;
    QSpinBox* m_width;
    QSpinBox* m_height;
    QComboBox* m_quality;
    QCheckBox* m_compare;
    QDoubleSpinBox* m_frameRate;
    QDoubleSpinBox* m_speed;
    QSpinBox* m_first;
    QSpinBox* m_last;
    QLabel* m_summary;
    QPushButton* m_export = nullptr;
};

}  // namespace rubble
