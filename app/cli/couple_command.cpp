// stillcut-cli couple FACE --cross ABOVE --spacing 40 --diameter 12 --stickout 60 --out TIP.csv

#include <cstdio>
#include <memory>
#include <string_view>

#include "app/cli/command.h"
#include "app/cli/modes_text.h"
#include "app/cli/out_path.h"
#include "app/cli/tap_options.h"
#include "core/milling/coupling/receptance_coupling.h"
#include "core/storage/atomic_file.h"

namespace stillcut::app {
namespace {

using namespace identify;
using namespace coupling;

struct CoupleCommand {
  std::string face, cross, out, modes, material = "carbide", theory = "timoshenko";
  double spacing_mm = 0.0, diameter_mm = 0.0, shank_mm = 0.0, stickOut_mm = 0.0, flutes_mm = 0.0;
  double young_gpa = 0.0, density = 0.0, loss = -1.0;
  ToolGeometry tool;
  TapOptions tap;
};

BeamMaterial materialOf(const CoupleCommand& c) {
  BeamMaterial material = c.material == "hss" ? highSpeedSteel() : carbide();
  if (c.young_gpa > 0.0) material.young = 1e9 * c.young_gpa;
  if (c.density > 0.0) material.density = c.density;
  if (c.loss >= 0.0) material.lossFactor = c.loss;
  return material;
}

Result<std::vector<BeamSection>> toolOf(const CoupleCommand& c) {
  ToolGeometry tool = c.tool;
  tool.diameter = Metres(1e-3 * c.diameter_mm);
  tool.shank = Metres(1e-3 * c.shank_mm);
  tool.stickOut = Metres(1e-3 * c.stickOut_mm);
  tool.fluteLength = Metres(1e-3 * c.flutes_mm);
  return sectionsOf(tool, "couple");
}

// What a measurement gives along each axis; its unit has to be known, for nothing is fitted that could tell it.
Result<std::vector<AxisModes>> responsesOf(const std::string& file, const ModalRequest& request) {
  auto answer = measureResponses({file}, request);
  if (!answer) return answer.error();
  for (const Message& remark : answer->remarks) std::printf("%s\n", text(remark).c_str());
  for (const AxisModes& axis : answer->axes) {
    if (!axis.frf.unitKnown) {
      return Error{file, message("does not say the unit of its response"),
                   message("give --unit m/N, mm/N, um/N, (m/s^2)/N or g/N")};
    }
  }
  return std::move(answer->axes);
}

// What the frequencies hang on, in plain numbers.
void printDoubt(const TipResponse& tip, const Frf& otherTheory, const ModalOptions& options) {
  const auto first = [&](const Frf& frf) {
    const auto fit = fitModes(frf, options);
    if (!fit) return 0.0;
    const IdentifiedMode* deepest = &fit->modes.front();
    for (const IdentifiedMode& m : fit->modes) deepest = m.depth > deepest->depth ? &m : deepest;
    return deepest->mode.frequency.value;
  };
  std::printf("deepest mode at %.0f Hz; with a holder that cannot rotate %.0f Hz, with the other beam theory %.0f Hz\n",
              first(tip.tip), first(tip.noRotation), first(otherTheory));
  std::printf("the clamping of the tool is taken as rigid and without damping: tap one tool to see how near that is\n");
}

std::string columnsOf(const std::vector<AxisModes>& axes) {
  std::string out = "Frequency [Hz]";
  for (const AxisModes& a : axes) {
    const std::string axis(name(a.axis == Axis::Unknown ? Axis::X : a.axis));
    for (const std::string_view part : {",Re G", ",Im G"}) out.append(part).append(axis).append(axis).append(" [m/N]");
  }
  out += "\n";
  for (std::size_t i = 0; i < axes.front().frf.value.size(); ++i) {
    char cell[80];
    std::snprintf(cell, sizeof cell, "%.9g", axes.front().frf.frequency[i]);
    out += cell;
    for (const AxisModes& a : axes) {
      std::snprintf(cell, sizeof cell, ",%.9e,%.9e", a.frf.value[i].real(), a.frf.value[i].imag());
      out += cell;
    }
    out += "\n";
  }
  return out;
}

// The tip along one axis; printed as it is found.
Result<AxisModes> tipAlong(const AxisModes& face, const AxisModes* above, const CoupleCommand& c,
                           const ModalRequest& request) {
  const auto tool = toolOf(c);
  if (!tool) return tool.error();
  HolderResponse holder;
  holder.direct = face.frf;
  if (above != nullptr) holder.cross = above->frf;
  holder.spacing = Metres(1e-3 * c.spacing_mm);
  const bool timoshenko = c.theory == "timoshenko";
  const auto theory = timoshenko ? BeamTheory::Timoshenko : BeamTheory::EulerBernoulli;
  auto tip = couple(holder, *tool, materialOf(c), theory);
  if (!tip) return tip.error();
  const auto other =
      couple(holder, *tool, materialOf(c), timoshenko ? BeamTheory::EulerBernoulli : BeamTheory::Timoshenko);
  if (!other) return other.error();
  AxisModes along;
  along.axis = face.axis == Axis::Unknown ? Axis::X : face.axis;
  along.frf = tip->tip;
  along.remarks = tip->remarks;
  auto fit = fitModes(tip->tip, request.fit);
  if (!fit) return fit.error();
  along.remarks.insert(along.remarks.end(), fit->remarks.begin(), fit->remarks.end());
  along.fit = std::move(*fit);
  printModes(along);
  printDoubt(*tip, other->tip, request.fit);
  return along;
}

Status checkGiven(const CoupleCommand& c) {
  for (const std::string& out : {c.out, c.modes}) {
    if (const Status usable = checkOutPath(out, c.face); !usable) return usable.error();
  }
  if (c.cross.empty() == (c.spacing_mm == 0.0)) return Done{};
  return Error{message("couple"), message("--cross and --spacing belong together"),
               message("the second response and its distance from the face of the holder in mm")};
}

Result<std::vector<AxisModes>> tips(const CoupleCommand& c) {
  auto request = c.tap.understand();
  if (!request) return request.error();
  const auto face = responsesOf(c.face, *request);
  if (!face) return face.error();
  std::vector<AxisModes> above;
  if (!c.cross.empty()) {
    auto read = responsesOf(c.cross, *request);
    if (!read) return read.error();
    above = std::move(*read);
    if (above.size() != face->size()) {
      return Error{c.cross, message("holds other axes than %1", c.face), message("name the axis with --axis")};
    }
  }
  std::vector<AxisModes> out;
  for (std::size_t i = 0; i < face->size(); ++i) {
    auto along = tipAlong((*face)[i], above.empty() ? nullptr : &above[i], c, *request);
    if (!along) return along.error();
    out.push_back(std::move(*along));
  }
  return out;
}

int run(const CoupleCommand& c) {
  if (const Status given = checkGiven(c); !given) return fail(given.error());
  const auto axes = tips(c);
  if (!axes) return fail(axes.error());
  if (!c.out.empty()) {
    if (const Status saved = writeFileAtomically(c.out, columnsOf(*axes)); !saved) return fail(saved.error());
  }
  if (!c.modes.empty()) {
    if (const Status saved = saveAxes(*axes, c.face, c.modes); !saved) return fail(saved.error());
  }
  return kExitDone;
}

}  // namespace

void addCouple(CLI::App& app, int& exitCode) {
  auto c = std::make_shared<CoupleCommand>();
  CLI::App* sub =
      app.add_subcommand("couple", "Response at a tool's tip from a measured holder and the tool's geometry");
  sub->add_option("FACE", c->face, "Tap test at the face of the holder: frequency response or hammer record")
      ->required();
  sub->add_option("--cross", c->cross, "The same hit, response further up the holder: gives its rotation");
  sub->add_option("--spacing", c->spacing_mm, "How far up [mm]")->check(CLI::PositiveNumber);
  sub->add_option("--diameter", c->diameter_mm, "Diameter of the tool [mm]")->required()->check(CLI::PositiveNumber);
  sub->add_option("--stickout", c->stickOut_mm, "From the holder's face to the tip [mm]")
      ->required()
      ->check(CLI::PositiveNumber);
  sub->add_option("--flutes", c->flutes_mm, "Length of the flutes outside the holder [mm]");
  sub->add_option("--shank", c->shank_mm, "Diameter of the shank [mm]; left out: as --diameter");
  sub->add_option("--flute-ratio", c->tool.fluteRatio, "Diameter that stands for the fluted part, over the tool's")
      ->capture_default_str();
  sub->add_option("--material", c->material, "carbide or hss")->check(CLI::IsMember({"carbide", "hss"}));
  sub->add_option("--young", c->young_gpa, "Young's modulus instead of the material's [GPa]");
  sub->add_option("--density", c->density, "Density instead of the material's [kg/m^3]");
  sub->add_option("--loss", c->loss, "Loss factor instead of the material's");
  sub->add_option("--theory", c->theory, "timoshenko or euler")->check(CLI::IsMember({"timoshenko", "euler"}));
  sub->add_option("--out", c->out, "Write the frequency response at the tip to a .csv file");
  sub->add_option("--modes-out", c->modes, "Write its modes to MODES.toml");
  c->tap.add(*sub);
  sub->callback([c, &exitCode] { exitCode = run(*c); });
}

}  // namespace stillcut::app
