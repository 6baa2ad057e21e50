// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>
#include <optional>
#include <string>

#include "widgets/common/filedialog.h"
#include "widgets/scope/scoperecord.h"

class QImage;
class QMenu;

namespace nmc {

class ScopeStrips;

/// What a file is to hold. May take a second to make, and be made in any thread.
using FileContent = std::function<std::string()>;

/// Takes what is seen out of the scope: samples as CSV, a picture as PNG, SVG or a page of PDF, onto the
/// clipboard or to a printer. It asks for the file, and takes the picture in the next frame.
class ScopeExport : public QObject {
    Q_OBJECT

public:
    explicit ScopeExport(QWidget* panel);

    [[nodiscard]] QMenu* menu() const { return m_menu; }
    /// What a frame shows: to be called after each one, with its time. `title`: what it is called when it is
    /// not live.
    void take(ScopeStrips& strips, const History& history, double now, const ScopeOrigin& origin,
              const QString& title);

signals:
    /// take() is to be called soon.
    void frameWanted();
    void saveRequested(const QString& path, const nmc::FileContent& content);
    void printRequested(const QByteArray& pdf);

private:
    enum class Kind : std::uint8_t { Csv, Png, Svg, Pdf, Clipboard, Printer };
    struct Wanted {
        Kind kind = Kind::Csv;
        QString path{};
        int form = 0;  ///< of CSV: which of the dialog's filters was chosen
    };

    void addAction(Kind kind, const QString& objectName, const QString& text, const QString& meaning);
    void choose(Kind kind);
    void want(const Wanted& wanted);
    static void copy(const QImage& image, const std::string& samples);

    QWidget* m_panel;
    QMenu* m_menu;
    QString m_folder;
    std::optional<Wanted> m_wanted;
};

}  // namespace nmc
