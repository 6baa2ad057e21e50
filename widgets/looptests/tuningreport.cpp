// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/looptests/tuningreport.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QImage>
#include <QLocale>
#include <QPdfWriter>
#include <QTextDocument>

#include "widgets/common/dates.h"
#include "widgets/common/picture.h"
#include "widgets/common/sharedwords.h"
#include "widgets/common/words.h"
#include "widgets/looptests/bodeplot.h"
#include "widgets/looptests/looptestwords.h"
#include "widgets/panels/gainsmeaning.h"
#include "widgets/response/modelwords.h"
#include "widgets/response/responseplot.h"
#include "widgets/response/responsewords.h"

namespace nmc {

using namespace Qt::StringLiterals;

namespace {

class Report {
    Q_DECLARE_TR_FUNCTIONS(Report)
};

constexpr QSize kStepPicture{380, 200};
constexpr QSize kBodePicture{380, 290};

QString picture(QWidget& plot, const QSize& size, const QString& what) {
    const OnPaper paper(plot, size);
    plot.setAttribute(Qt::WA_DontShowOnScreen);
    plot.ensurePolished();
    QImage image(size * kSharpness, QImage::Format_RGB32);
    image.setDevicePixelRatio(kSharpness);
    image.fill(Qt::white);
    plot.render(&image);
    return u"<img width=\"%1\" height=\"%2\" alt=\"%3\" src=\"data:image/png;base64,%4\">"_s.arg(size.width())
        .arg(size.height())
        .arg(what.toHtmlEscaped(), QString::fromLatin1(pngOf(image).toBase64()));
}

QString lines(const QStringList& lines) {
    QStringList escaped;
    for (const QString& line : lines)
        escaped << line.toHtmlEscaped();
    return escaped.join(u"<br>"_s);
}

QString htmlSection(const QString& title, const QString& left, const QStringList& right) {
    return u"<h3>%1</h3><table width=\"100%\"><tr><td>%2</td><td width=\"40%\">%3</td></tr></table>"_s.arg(
        title.toHtmlEscaped(), left, lines(right));
}

QString gainsTable(const servo::SetGain& gains) {
    QString names, values;
    for (const Gain gain : kAllGains) {
        const auto value = gainOf(gains, gain);
        names += u"<th>%1</th>"_s.arg(gainLetters(gain));
        values += u"<td align=\"right\">%1</td>"_s.arg(value ? QString::number(*value) : u"–"_s);
    }
    return u"<h3>%1</h3><table border=\"1\" cellspacing=\"0\" cellpadding=\"4\"><tr>%2</tr><tr>%3</tr></table>"_s
        .arg(Common::tr("Gains").toHtmlEscaped(), names, values);
}

QString simulatedWords() {
    return Report::tr("simulated; no real motor moved");
}

/// A run may be of another machine at another port, or of the simulator.
QString whenAndWhere(const KeptResponse& kept) {
    QStringList parts{QLocale().toString(dateIn(kept.startedAt), QLocale::ShortFormat),
                      texts::portName(QString::fromStdString(kept.port))};
    if (kept.simulated)
        parts << simulatedWords();
    return parts.join(u" · "_s);
}

QString frequencySection(const FrequencyPage::Found& found) {
    const ProcedureReport& measured = found.report;
    BodePlot plot;
    plot.showCurves({{{}, measured.frequencies}}, 0.0);
    QStringList words = texts::frequencyFigures(measured.frequencies);
    if (measured.gains)
        words.prepend(texts::gainsInShort(*measured.gains));
    if (measured.speed != 0.0)
        words << Report::tr("Speed while measuring %1 counts/s").arg(texts::fixed(measured.speed, 0));
    words << QLocale().toString(found.measured, QLocale::ShortFormat);
    return htmlSection(Common::tr("Frequency response"),
                       picture(plot, kBodePicture, Common::tr("Frequency response")), words);
}

QString responseSection(const KeptResponse& kept) {
    ResponsePlot plot;
    plot.showRuns(&kept, nullptr);
    const ResponseMetrics& metrics = kept.run.metrics;
    const ResponseTaken& taken = kept.run.taken;
    if (const auto& move = kept.run.move)
        return htmlSection(
            texts::responseMethod(taken.method),
            picture(plot, kStepPicture, texts::responseMethod(taken.method)),
            {Report::tr("%1 counts in %2 s")
                 .arg(taken.goal - taken.from)
                 .arg(texts::readout(move->moveTime, 3)),
             texts::gainsInShort(taken.gains),
             Report::tr("Settling to ±%1 counts for %2 s: %3")
                 .arg(texts::readout(kept.run.window.counts), texts::readout(kept.run.window.dwell),
                      texts::responseTime(move->settling)),
             Report::tr("Peak error %1").arg(texts::responseErrorSize(move->peak, kept.scale)),
             Report::tr("RMS error %1").arg(texts::responseErrorSize(move->rms, kept.scale)),
             whenAndWhere(kept)});
    return htmlSection(
        Common::tr("Step response"), picture(plot, kStepPicture, Common::tr("Step response")),
        {Report::tr("%1 counts, %2").arg(taken.goal - taken.from).arg(texts::responseMethod(taken.method)),
         texts::gainsInShort(taken.gains), Common::tr("Rise %1").arg(texts::responseTime(metrics.rise)),
         Common::tr("Overshoot %1").arg(texts::responseOvershoot(metrics.overshoot)),
         Report::tr("Settling to ±%1 %: %2")
             .arg(texts::readout(kept.run.bandPercent), texts::responseTime(metrics.settling)),
         Common::tr("Steady-state error %1").arg(texts::responseError(metrics.steadyError, kept.scale)),
         whenAndWhere(kept)});
}

}  // namespace

QString reportHtml(const TuningReport& report) {
    QString page =
        u"<!DOCTYPE html><html><head><meta charset=\"utf-8\"><title>%1</title></head>"
        "<body style=\"font-family: sans-serif; font-size: 9pt\"><h2>%1</h2>"_s.arg(
            Report::tr("Tuning of %1").arg(report.module).toHtmlEscaped());
    QStringList about{report.chip, report.port};
    if (!report.machine.isEmpty())
        about.prepend(report.machine);
    about << QLocale().toString(report.made, QLocale::ShortFormat)
          << u"NMC Panel %1"_s.arg(QCoreApplication::applicationVersion());
    if (report.simulated)
        about << simulatedWords();
    page += u"<p>%1</p>"_s.arg(about.join(u" · "_s).toHtmlEscaped());
    if (report.gains)
        page += gainsTable(*report.gains);
    if (report.run)
        page += responseSection(*report.run);
    if (!report.motor.isEmpty())
        page += u"<h3>%1</h3><p>%2</p>"_s.arg(Report::tr("Motor").toHtmlEscaped(), lines(report.motor));
    if (report.frequency)
        page += frequencySection(*report.frequency);
    return page + u"</body></html>\n"_s;
}

QByteArray reportPdf(const TuningReport& report) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setTitle(Report::tr("Tuning of %1").arg(report.module));
    QTextDocument document;
    document.setHtml(reportHtml(report));
    document.print(&writer);
    buffer.close();
    return bytes;
}

}  // namespace nmc
