#pragma once

#include "editor/dialogs/OutputPath.h"
#include "viewport/scene/Camera.h"

#include <QDialog>
#include <QStringList>

#include <cstdint>
#include <optional>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace rubble {

class NumberField;

/// The simulation that is to be exported.
struct VideoSubject {
    OutputDefaults defaults;   // of the target, if no video was exported before
    std::uint64_t length = 0;  // steps that were simulated; 0: none, a saved throw is to be simulated
    QStringList throws;        // the names of the saved throws
    double stepLength = 0.0;   // s
    double speed = 1.0;        // the playback speed
    double stepCost = 0.0;     // s, of computing a step; 0: unknown
};

/// "about 40 s", "about 3 min"
QString aboutDurationText(double seconds);

struct VideoOptions {
    QString path;          // of a video with its suffix, or of the folder of its images
    bool isVideo = false;  // otherwise a sequence of images
    ImageSize size;
    int samples = 0;                    // see VideoPlan
    double frameRate = 30.0;            // frames per second
    double speed = 1.0;                 // 1: real time
    std::uint64_t first = 0, last = 0;  // steps
    int savedThrow = 0;                 // index in VideoSubject::throws, where nothing was simulated
    bool isCompared = false;            // beside a simulation without destruction
    bool hasSound = false;              // of a video
    /// The size of a frame.
    ImageSize frameSize() const;
    /// Simulation steps from one frame to the next.
    double stepsPerFrame(double stepLength) const { return speed / (frameRate * stepLength); }
};

/// Asks how to export a video, and shows how many frames it will have and how long that takes. Starts with the options
/// of the last video.
class VideoDialog : public QDialog {
    Q_OBJECT
public:
    VideoDialog(const VideoSubject& subject, QWidget* parent);
    VideoOptions options() const;
    /// Emits estimateNeeded().
    void requestEstimate();
    /// Shows how long the video takes. No duration: unknown.
    void setFrameCost(std::optional<double> secondsPerFrame, bool isMeasuring);

    void accept() override;

signals:
    /// How long a frame takes is to be measured; setFrameCost() is called then.
    void estimateNeeded(const VideoOptions& options);

private:
    void addTarget(QFormLayout& form);
    void addFrames(QFormLayout& form);
    void addTime(QFormLayout& form);
    void connectFields();
    void restoreOptions();
    void updateSuffix();
    void browse();
    void updateSummary();
    double longestTime() const;
    std::uint64_t stepAt(const NumberField& time) const;
    QString error(const VideoOptions& options, int frames) const;
    QString summary(const VideoOptions& options, int frames) const;
    void updateEstimate();

    VideoSubject m_subject;
    bool m_hasFfmpeg;
    QComboBox* m_kind;
    QLineEdit* m_path;
    QComboBox* m_throw = nullptr;  // only where nothing was simulated
    NumberField* m_width;
    NumberField* m_height;
    QComboBox* m_quality;
    QCheckBox* m_compare;
    QCheckBox* m_sound;
    NumberField* m_frameRate;
    NumberField* m_speed;
    NumberField* m_first;
    NumberField* m_last;
    QLabel* m_steps;
    QLabel* m_summary;
    QLabel* m_duration;
    std::optional<VideoOptions> m_estimated;  // those of the last request
    std::optional<double> m_frameCost;        // s
    bool m_isMeasuring = false;
    QPushButton* m_export = nullptr;
};

}  // namespace rubble
