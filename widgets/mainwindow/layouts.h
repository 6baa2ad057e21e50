// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>
#include <functional>

class QAction;
class QMainWindow;
class QSettings;

namespace nmc {

/// What a window is laid out for: which docks are open, where they stand, and how much room each has. Each
/// layout comes back as it was left.
class Layouts : public QObject {
    Q_OBJECT

public:
    enum class Kind : quint8 {
        Operate,  ///< motions, with everything around them
        Tune,     ///< plots, with gains and step beside them
        Chain,    ///< modules, packets and messages
    };

    /// Both must outlive it. `arrange` puts the docks where they stand at first in that layout.
    Layouts(QMainWindow& window, QSettings& settings, std::function<void(Kind)> arrange);

    [[nodiscard]] const QList<QAction*>& actions() const { return m_actions; }
    [[nodiscard]] Kind kind() const { return m_kind; }
    /// The one that was chosen last, as it was left; once the window has its docks and its size.
    void restore();
    void save();
    /// The one that is chosen, as it stands at first.
    void reset();

signals:
    /// The docks stand already.
    void chosen(nmc::Layouts::Kind kind);

private:
    void add(const QString& objectName, const QString& text, const QString& meaning, const QKeySequence& key);
    void choose(Kind kind);
    void show();

    QMainWindow& m_window;
    QSettings& m_settings;
    std::function<void(Kind)> m_arrange;
    QList<QAction*> m_actions;  ///< in the order of Kind
    Kind m_kind = Kind::Operate;
};

}  // namespace nmc
