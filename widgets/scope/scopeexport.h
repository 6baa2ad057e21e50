// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>

#include "widgets/common/filedialog.h"
#include "widgets/scope/scoperecord.h"

class QImage;
class QMenu;

namespace nmc {

class Requests;
class ScopeStrips;

/// The content of a recording with the samples in [from, to].
[[nodiscard]] FileContent samplesBetween(TimePoint from, TimePoint to, const History& history,
                                         const std::vector<ScopeModule>& modules, const ScopeOrigin& origin);

/// Exports what the scope shows: samples as CSV, or a picture as PNG, SVG or a page of PDF, to the clipboard
/// or to a printer. It asks for a file name, and takes the picture in the next frame.
class ScopeExport : public QObject {
    Q_OBJECT

public:
    ScopeExport(Requests& requests, QWidget* panel);

    [[nodiscard]] QMenu* menu() const { return m_menu; }
    /// An export was requested that has not been carried out yet.
    [[nodiscard]] bool isDue() const { return m_wanted.has_value(); }
    /// Carries out the export that was requested, if any; call it after each frame, with the time of that
    /// frame. `title`: of the record or overlay that is shown; empty if there is none.
    void take(ScopeStrips& strips, const History& history, double now, const ScopeOrigin& origin,
              const QString& title);

signals:
    /// take() must be called soon.
    void frameWanted();

private:
    enum class Kind : std::uint8_t { Csv, Png, Svg, Pdf, Clipboard, Printer };
    struct Wanted {
        Kind kind = Kind::Csv;
        QString path{};
        QString suffix{};
        int form = 0;  ///< of CSV: index of the filter chosen in the dialog
    };

    void addAction(Kind kind, const QString& objectName, const QString& text, const QString& meaning);
    void choose(Kind kind);
    void want(const Wanted& wanted);
    static void copy(const QImage& image, const std::string& samples);

    Requests& m_requests;
    QWidget* m_panel;
    QMenu* m_menu;
    QString m_folder;
    std::optional<Wanted> m_wanted;
};

}  // namespace nmc
