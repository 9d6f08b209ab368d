#include "editor/dialogs/VideoDialog.h"

#include "core/asset/project/Ranges.h"
#include "core/io/media/PictureSequence.h"
#include "core/io/media/VideoFile.h"
#include "editor/document/FilePath.h"
#include "editor/document/ShownText.h"
#include "editor/widgets/ComboBox.h"
#include "editor/widgets/NumberField.h"
#include "editor/widgets/ProjectRange.h"
#include "editor/widgets/TypedFields.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"
#include "viewport/render/OffscreenRenderer.h"
#include "viewport/video/Video.h"

#include <QCheckBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QSettings>

#include <cmath>

namespace rubble {

namespace {

enum Output { kVideoOutput, kImagesOutput };  // the items of the box
constexpr const char* kVideoSuffix = ".mp4";
constexpr int kMinImageSide = 16;         // pixels
constexpr double kDefaultDuration = 3.0;  // s, of a saved throw

QHBoxLayout* createRow(const QList<QWidget*>& widgets) {
    auto* row = new QHBoxLayout;
    for (QWidget* widget : widgets) row->addWidget(widget);
    return row;
}

NumberField* createField(const FieldRange& range, const QString& unit, const QString& name, const QString& hint) {
    auto* field = new NumberField;
    field->setRange(range);
    field->setFormat({.unit = unit});
    field->setAccessibleName(name);
    field->setHint(hint);
    return field;
}

QString withoutVideoSuffix(const QString& path) {
    if (!isVideoPath(toPath(path))) return path;
    return path.left(path.lastIndexOf('.'));
}

}  // namespace

QString aboutDurationText(double seconds) {
    constexpr double kMinute = 60.0, kHour = 3600.0;
    const double step = seconds < 10.0 ? 1.0 : 5.0;
    const double rounded = std::max(1.0, step * std::round(seconds / step));
    if (rounded < kMinute) return VideoDialog::tr("about %1").arg(fixedQuantity(rounded, 0, Units::seconds()));
    if (seconds < kHour) return VideoDialog::tr("about %L1 min").arg(std::lround(seconds / kMinute));
    return VideoDialog::tr("about %L1 h").arg(seconds / kHour, 0, 'f', 1);
}

VideoDialog::VideoDialog(const VideoSubject& subject, QWidget* parent)
    : QDialog(parent), m_subject(subject), m_hasFfmpeg(findFfmpeg().has_value()) {
    setWindowTitle(tr("Export Video"));
    auto* form = new QFormLayout(this);
    addTarget(*form);
    addFrames(*form);
    addTime(*form);
    m_summary = addSummary(*form, "video-summary");
    m_duration = new QLabel;
    m_duration->setObjectName("video-duration");
    form->addRow(QString(), m_duration);
    m_export = addOutputButtons(*this, *form, tr("Export"));
    restoreOptions();
    connectFields();
    updateSummary();
    fitPath(*this);
}

void VideoDialog::addTarget(QFormLayout& form) {
    m_kind = comboBox({tr("Video (MP4)"), tr("Numbered images (PNG)")}, tr("Select the output format"));
    form.addRow(tr("F&ormat:"), m_kind);
    if (!m_hasFfmpeg) {
        m_kind->setEnabled(false);
        auto* note =
            new QLabel(tr("Videos need ffmpeg, which is not installed. Install it, or export images instead."));
        note->setObjectName("video-without-ffmpeg");
        note->setWordWrap(true);
        form.addRow(QString(), note);
    }
    m_path = new QLineEdit;
    m_path->setObjectName("video-path");
    m_path->setToolTip(tr("Set the file of the video or the folder for the images"));
    form.addRow(buddyLabel(tr("&Target:"), m_path), createPathRow(*m_path, [this] { browse(); }));
}

void VideoDialog::addFrames(QFormLayout& form) {
    const FieldRange sides = FieldRange::whole(kMinImageSide, kMaxImageSide);
    m_width = createField(sides, tr("px"), tr("Width"), tr("Set the width of the frames"));
    m_height = createField(sides, tr("px"), tr("Height"), tr("Set the height of the frames"));
    auto* row = createRow({m_width, new QLabel("×"), m_height});
    row->addStretch(1);
    form.addRow(buddyLabel(tr("&Size:"), m_width), row);
    m_quality = comboBox({tr("Draft"), tr("Good"), tr("Best")},
                         tr("Select the quality of light and edges; draft: as in the 3D view in motion"));
    m_quality->setObjectName("video-quality");
    form.addRow(tr("&Quality:"), m_quality);
    m_compare = new QCheckBox(tr("&Compare without destruction"));
    m_compare->setToolTip(tr("Show the same simulation without destruction on the left"));
    form.addRow(QString(), m_compare);
    m_sound = new QCheckBox(tr("S&ound of impacts and breaks"));
    m_sound->setObjectName("video-sound");
    m_sound->setToolTip(tr("Add what is heard from the camera; images have no sound"));
    form.addRow(QString(), m_sound);
}

void VideoDialog::addTime(QFormLayout& form) {
    if (m_subject.length == 0) {
        m_throw = comboBox(m_subject.throws, tr("Select the saved throw to simulate"));
        form.addRow(tr("Saved &throw:"), m_throw);
    }
    const FieldRange times{.min = 0.0, .max = longestTime()};
    const NumberFormat seconds = Units::seconds();
    m_first = createField(times, seconds.unit, tr("Start"), tr("Set the simulated time of the first frame"));
    m_last = createField(times, seconds.unit, tr("End"), tr("Set the simulated time of the last frame"));
    m_last->setValue(m_subject.length > 0 ? times.max : kDefaultDuration);
    m_steps = new QLabel;
    m_steps->setObjectName("video-steps");
    auto* row = createRow({m_first, new QLabel(tr("to")), m_last, m_steps});
    row->addStretch(1);
    form.addRow(buddyLabel(tr("Tim&e:"), m_first), row);
    m_frameRate = createField(fieldRange(ProjectNumber::FrameRate), tr("fps"), tr("Frame rate"),
                              tr("Set the frames per second; 24 to 60 look smooth"));
    form.addRow(tr("Frame &rate:"), m_frameRate);
    m_speed = createField({.min = 0.01, .max = 100.0}, tr("×"), tr("Speed"),
                          tr("Set the playback speed; values below 1 give slow motion"));
    m_speed->setValue(m_subject.speed);
    form.addRow(tr("S&peed:"), m_speed);
}

void VideoDialog::connectFields() {
    connect(m_kind, &QComboBox::currentIndexChanged, this, &VideoDialog::updateSuffix);
    connect(m_path, &QLineEdit::textChanged, this, &VideoDialog::updateSummary);
    connect(m_quality, &QComboBox::currentIndexChanged, this, &VideoDialog::updateSummary);
    connect(m_compare, &QCheckBox::toggled, this, &VideoDialog::updateSummary);
    for (NumberField* field : {m_width, m_height, m_first, m_last, m_frameRate, m_speed}) {
        connect(field, &NumberField::edited, this, &VideoDialog::updateSummary);
    }
}

/// Shows the options of the last video.
void VideoDialog::restoreOptions() {
    const QSettings settings;
    const auto stored = [&](const QString& key, const QVariant& otherwise = {}) {
        return settings.value("video/" + key, otherwise);
    };
    restoreIndex(*m_kind, m_hasFfmpeg ? stored("pictures", kVideoOutput).toInt() : kImagesOutput);
    m_width->setValue(std::clamp(stored("width", 1280).toInt(), kMinImageSide, kMaxImageSide));
    m_height->setValue(std::clamp(stored("height", 720).toInt(), kMinImageSide, kMaxImageSide));
    restoreIndex(*m_quality, stored("quality", 1).toInt());
    m_frameRate->setValue(stored("rate", 30.0).toDouble());
    m_sound->setChecked(stored("sound", false).toBool());
    m_path->setText(unusedPathIn(stored("folder"), m_subject.defaults.folder,
                                 tr("%1 video").arg(m_subject.defaults.name), kVideoSuffix));
    updateSuffix();
}

ImageSize VideoOptions::frameSize() const {
    return {isCompared ? 2 * size.width + kPlaybackGap : size.width, size.height};
}

/// s, the time of the last step that can be exported.
double VideoDialog::longestTime() const {
    const double steps =
        m_subject.length > 0 ? static_cast<double>(m_subject.length) : rangeOf(ProjectNumber::Step).max;
    return steps * m_subject.stepLength;
}

/// The step nearest to a time.
std::uint64_t VideoDialog::stepAt(const NumberField& time) const {
    return static_cast<std::uint64_t>(std::llround(time.value() / m_subject.stepLength));
}

VideoOptions VideoDialog::options() const {
    VideoOptions options{.path = QDir::fromNativeSeparators(m_path->text()),
                         .isVideo = m_kind->currentIndex() == kVideoOutput,
                         .size = {static_cast<int>(m_width->value()), static_cast<int>(m_height->value())},
                         .samples = videoSamplesOf(static_cast<RenderQuality>(m_quality->currentIndex())),
                         .frameRate = m_frameRate->value(),
                         .speed = m_speed->value(),
                         .first = stepAt(*m_first),
                         .last = stepAt(*m_last),
                         .savedThrow = m_throw ? m_throw->currentIndex() : 0,
                         .isCompared = m_compare->isChecked(),
                         .hasSound = m_sound->isEnabled() && m_sound->isChecked()};
    if (options.isVideo && !options.path.isEmpty() && !isVideoPath(toPath(options.path))) options.path += kVideoSuffix;
    return options;
}

void VideoDialog::accept() {
    if (!commitFields(*this) || !m_export->isEnabled()) return;
    const VideoOptions accepted = options();
    QSettings settings;
    if (m_hasFfmpeg) settings.setValue("video/pictures", m_kind->currentIndex());
    settings.setValue("video/width", accepted.size.width);
    settings.setValue("video/height", accepted.size.height);
    settings.setValue("video/quality", m_quality->currentIndex());
    settings.setValue("video/rate", accepted.frameRate);
    settings.setValue("video/sound", m_sound->isChecked());
    settings.setValue("video/folder", settingOf(QFileInfo(accepted.path).absolutePath()));
    QDialog::accept();
}

void VideoDialog::updateSuffix() {
    const QString base = withoutVideoSuffix(m_path->text());
    m_path->setText(m_kind->currentIndex() == kVideoOutput ? base + kVideoSuffix : base);
    m_sound->setEnabled(m_kind->currentIndex() == kVideoOutput);
    updateSummary();
}

void VideoDialog::browse() {
    const QString title = windowTitle();
    const QString path =
        m_kind->currentIndex() == kVideoOutput
            ? QFileDialog::getSaveFileName(this, title, m_path->text(), tr("Videos (*.mp4 *.mkv *.mov *.webm)"))
            : QFileDialog::getExistingDirectory(this, title, QFileInfo(m_path->text()).path());
    if (!path.isEmpty()) m_path->setText(QDir::toNativeSeparators(path));
}

/// Shows what will be written, or what is wrong with the options.
void VideoDialog::updateSummary() {
    m_first->setRange({.min = 0.0, .max = m_last->value()});
    m_last->setRange({.min = m_first->value(), .max = longestTime()});
    const VideoOptions current = options();
    m_steps->setText(tr("(steps %L1 to %L2)").arg(current.first).arg(current.last));
    const int frames = frameCount(static_cast<double>(current.first), static_cast<double>(current.last),
                                  current.stepsPerFrame(m_subject.stepLength));
    const QString wrong = error(current, frames);
    m_summary->setText(wrong.isEmpty() ? summary(current, frames) : wrong);
    m_export->setEnabled(wrong.isEmpty());
    const bool isOther = m_estimated && (m_estimated->size != current.size || m_estimated->samples != current.samples);
    isOther ? requestEstimate() : updateEstimate();
}

void VideoDialog::requestEstimate() {
    m_estimated = options();
    emit estimateNeeded(*m_estimated);
}

void VideoDialog::setFrameCost(std::optional<double> secondsPerFrame, bool isMeasuring) {
    m_frameCost = secondsPerFrame;
    m_isMeasuring = isMeasuring;
    updateEstimate();
}

/// Of rendering, and of simulating up to the last frame.
void VideoDialog::updateEstimate() {
    if (!m_export->isEnabled() || !m_frameCost)
        return m_duration->setText(m_isMeasuring ? tr("Measuring how long this takes…") : QString());
    const VideoOptions current = options();
    const int frames = frameCount(static_cast<double>(current.first), static_cast<double>(current.last),
                                  current.stepsPerFrame(m_subject.stepLength));
    const double once = frames * *m_frameCost + static_cast<double>(current.last) * m_subject.stepCost;
    m_duration->setText(tr("This takes %1.").arg(aboutDurationText(current.isCompared ? 2.0 * once : once)));
}

QString VideoDialog::error(const VideoOptions& options, int frames) const {
    if (options.path.isEmpty()) return tr("The target is empty. Enter a path.");
    if (!options.isVideo && isVideoPath(toPath(options.path)))
        return tr("The target is a file. Enter a folder for the images.");
    if (options.isVideo) {
        const QString fault = outputFault(options.path, {}, {".mp4", ".mkv", ".mov", ".webm"});
        if (!fault.isEmpty()) return fault;
    }
    if (frames <= kMaxPictures) return {};
    return tr("The video would have %L1 frames; at most %L2 are possible. Use a shorter time, a lower frame rate or a "
              "higher speed.")
        .arg(frames)
        .arg(kMaxPictures);
}

QString VideoDialog::summary(const VideoOptions& options, int frames) const {
    const auto seconds = [](double time) { return fixedQuantity(time, 1, Units::seconds()); };
    const double simulated = static_cast<double>(options.last - options.first) * m_subject.stepLength;
    const ImageSize size = options.frameSize();
    QString text = tr("%Ln frame(s) of %1 × %2 pixels: %3 of video from %4 of simulation.", nullptr, frames)
                       .arg(size.width)
                       .arg(size.height)
                       .arg(seconds(static_cast<double>(frames) / options.frameRate), seconds(simulated));
    if (options.isVideo && exists(statusOf(options.path))) {
        text += ' ' + tr("%1 will be replaced.").arg(fileNameText(options.path));
    }
    return text;
}

}  // namespace rubble

#include "moc_VideoDialog.cpp"
