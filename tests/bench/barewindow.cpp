// SPDX-License-Identifier: GPL-3.0-or-later
// What the panel's start-up is measured against: a bare QMainWindow with one chart, up to its first paint.
#include <QApplication>
#include <QChartView>
#include <QMainWindow>
#include <QTimer>

int main(int argc, char** argv) {
    const QApplication application(argc, argv);
    QMainWindow window;
    window.setCentralWidget(new QChartView(&window));
    window.resize(1'100, 800);
    window.show();
    QTimer::singleShot(0, &window, [&window] { QTimer::singleShot(0, &window, [] { QCoreApplication::exit(0); }); });
    return QApplication::exec();
}
