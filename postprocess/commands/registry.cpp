// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
//
// To add a command: one file commands/NAME_command.cpp with add_NAME_command, its row here, its
// page doc/NAME.md and its test in tests/cli.
#include "command.h"

namespace ellipsoid::post {

void add_pile_command(CLI::App&, int&);
void add_repose_command(CLI::App&, int&);
void add_porosity_command(CLI::App&, int&);
void add_coordination_command(CLI::App&, int&);
void add_heap_command(CLI::App&, int&);
void add_bed_command(CLI::App&, int&);
void add_orientation_command(CLI::App&, int&);
void add_contacts_command(CLI::App&, int&);
void add_fields_command(CLI::App&, int&);
void add_voronoi_command(CLI::App&, int&);
void add_mixing_command(CLI::App&, int&);
void add_pairs_command(CLI::App&, int&);
void add_trajectory_command(CLI::App&, int&);
void add_flow_command(CLI::App&, int&);
void add_energy_command(CLI::App&, int&);
void add_summary_command(CLI::App&, int&);
void add_render_command(CLI::App&, int&);
void add_render3d_command(CLI::App&, int&);
void add_film_command(CLI::App&, int&);
void add_paraview_command(CLI::App&, int&);
void add_template_command(CLI::App&, int&);
void add_plot_command(CLI::App&, int&);
void add_report_command(CLI::App&, int&);
void add_view_command(CLI::App&, int&);

const CommandRow command_rows[] = {
    {"pile", add_pile_command},
    {"repose", add_repose_command},
    {"porosity", add_porosity_command},
    {"coordination", add_coordination_command},
    {"heap", add_heap_command},
    {"bed", add_bed_command},
    {"orientation", add_orientation_command},
    {"contacts", add_contacts_command},
    {"fields", add_fields_command},
    {"voronoi", add_voronoi_command},
    {"mixing", add_mixing_command},
    {"pairs", add_pairs_command},
    {"trajectory", add_trajectory_command},
    {"flow", add_flow_command},
    {"energy", add_energy_command},
    {"summary", add_summary_command},
    {"render", add_render_command},
    {"render3d", add_render3d_command},
    {"film", add_film_command},
    {"paraview", add_paraview_command},
    {"template", add_template_command},
    {"plot", add_plot_command},
    {"report", add_report_command},
    {"view", add_view_command},
};
const unsigned command_count = sizeof(command_rows) / sizeof(command_rows[0]);

} // namespace ellipsoid::post
