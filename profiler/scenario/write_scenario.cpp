#include <algorithm>
#include <charconv>
#include <cstdio>

#include "profiler/scenario/names.h"
#include "profiler/scenario/read_scenario.h"

namespace reprise {
namespace {

namespace fs = std::filesystem;

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    if (letter == '"' || letter == '\\') {
      out += '\\';
      out += letter;
    } else if (code < 0x20 || code == 0x7f) {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(code));
      out += escape;
    } else {
      out += letter;
    }
  }
  return out + "\"";
}

template <typename Real>
std::string shortest(Real value) {
  char text[64];
  const auto end = std::to_chars(text, text + sizeof text, value);
  return std::string(text, end.ptr);
}

// The shortest text that reads back (as double, then narrowed) to the same float.
std::string number(float value) {
  std::string text = shortest(value);
  double back = 0;
  std::from_chars(text.data(), text.data() + text.size(), back);
  if (static_cast<float>(back) != value) text = shortest(static_cast<double>(value));
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

template <typename Sequence>
std::string numbers(const Sequence& values) {
  std::string text = "[";
  for (const float value : values) text += (text.size() > 1 ? ", " : "") + number(value);
  return text + "]";
}

std::string truth(bool value) {
  return value ? "true" : "false";
}

struct TrackText {
  std::string operator()(const FixedTrack& track) const { return numbers(track.value); }
  std::string operator()(const KeyFramesTrack& track) const {
    std::string text = "{ key_frames = [";
    for (std::size_t i = 0; i < track.times_s.size(); ++i) {
      text += (i > 0 ? ", " : "") + ("{ at_s = " + number(track.times_s[i])) +
              ", value = " + numbers(track.values[i]) + " }";
    }
    return text + "] }";
  }
  std::string operator()(const OscillationTrack& track) const {
    return "{ oscillate = { base = " + numbers(track.base) + ", amplitude = " + numbers(track.amplitude) +
           ", period_s = " + number(track.period_s) + ", phase_rad = " + number(track.phase_rad) + " } }";
  }
  std::string operator()(const RandomWalkTrack& track) const {
    return "{ random_walk = { base = " + numbers(track.base) + ", extent = " + numbers(track.extent) +
           ", step_per_s = " + number(track.step_per_s) + ", seed = " + std::to_string(track.seed) + " } }";
  }
  std::string operator()(const FlickerTrack& track) const {
    return "{ flicker = { base = " + numbers(track.base) + ", amplitude = " + numbers(track.amplitude) +
           ", rate_hz = " + number(track.rate_hz) + ", seed = " + std::to_string(track.seed) + " } }";
  }
};

std::string trackText(const Track& track) {
  return std::visit(TrackText(), track);
}

std::string motionText(const Motion& motion) {
  return "{ translate = " + trackText(motion.translate) + ", rotate_deg = " + trackText(motion.rotate_deg) +
         ", scale = " + trackText(motion.scale) + ", spin_axis = " + numbers(motion.spin_axis) +
         ", spin_rad_per_frame = " + number(motion.spin_rad_per_frame) + " }";
}

std::string meshText(const MeshSpec& mesh) {
  std::string text = "{ kind = " + quoted(spellingOf(kMeshKinds, mesh.kind)) +
                     ", segments_u = " + std::to_string(mesh.segments_u) +
                     ", segments_v = " + std::to_string(mesh.segments_v);
  switch (mesh.kind) {
    case MeshKind::kSphere:
      text += ", radius = " + number(mesh.radius);
      break;
    case MeshKind::kTorusKnot:
      text += ", radius = " + number(mesh.radius) + ", tube_radius = " + number(mesh.tube_radius) +
              ", p = " + std::to_string(mesh.p) + ", q = " + std::to_string(mesh.q);
      break;
    case MeshKind::kPlane:
      text += ", size = " + number(mesh.size);
      break;
    case MeshKind::kTerrain:
      text += ", size = " + number(mesh.size) + ", height = " + number(mesh.height) +
              ", seed = " + std::to_string(mesh.seed);
      break;
    case MeshKind::kRevolution:
      text += ", profile = [";
      for (std::size_t i = 0; i < mesh.profile.size(); ++i)
        text += (i > 0 ? ", " : "") + numbers(mesh.profile[i]);
      text += "]";
      break;
    case MeshKind::kDisplacedSphere:
      text += ", radius = " + number(mesh.radius) + ", height = " + number(mesh.height) +
              ", cells = " + std::to_string(mesh.cells) + ", seed = " + std::to_string(mesh.seed);
      break;
  }
  return text + " }";
}

struct CameraPathText {
  std::string operator()(const OrbitPath& orbit) const {
    return "orbit = { target = " + numbers(orbit.target) + ", radius = " + number(orbit.radius) + ", height = " + number(orbit.height) +
           ", start_rad = " + number(orbit.start_rad) + ", radians_per_frame = " + number(orbit.radians_per_frame) + " }";
  }
  std::string operator()(const TrackPath& path) const {
    return "eye = " + trackText(path.eye) + ", target = " + trackText(path.target);
  }
  // The rows themselves: a copy of the scenario needs no other file.
  std::string operator()(const RecordedPath& path) const {
    std::string text = "recorded = [";
    for (const CameraKey& key : path.keys) {
      std::vector<float> row = {key.at_s};
      row.insert(row.end(), key.position.begin(), key.position.end());
      row.insert(row.end(), key.rotation.begin(), key.rotation.end());
      if (key.fov_y_deg > 0) row.push_back(key.fov_y_deg);
      text += (&key == &path.keys.front() ? "" : ", ") + numbers(row);
    }
    return text + "]";
  }
  std::string operator()(const ModelCameraPath& path) const {
    const auto* index = std::get_if<int>(&path.camera);
    return "gltf = { model = " + quoted(path.model) +
           ", camera = " + (index ? std::to_string(*index) : quoted(std::get<std::string>(path.camera))) + " }";
  }
};

std::string shakeAndCutsText(const Camera& camera) {
  std::string text;
  if (const auto& handheld = camera.handheld)
    text += ", handheld = { move = " + number(handheld->move) + ", turn_deg = " + number(handheld->turn_deg) +
            ", frequency_hz = " + number(handheld->frequency_hz) + ", seed = " + std::to_string(handheld->seed) + " }";
  for (const CameraCut& cut : camera.cuts)
    text += (&cut == &camera.cuts.front() ? ", cuts = [{ at_s = " : ", { at_s = ") + number(cut.at_s) + ", turn_deg = " + number(cut.turn_deg) +
            ", move = " + numbers(cut.move) + " }";
  return camera.cuts.empty() ? text : text + "]";
}

std::string cameraText(const Camera& camera) {
  std::string text = "{ " + std::visit(CameraPathText(), camera.path) + ", up = " + numbers(camera.up);
  if (!std::holds_alternative<ModelCameraPath>(camera.path)) {
    text += ", orthographic = " + truth(camera.orthographic);
    text += camera.orthographic ? ", ortho_height = " + number(camera.ortho_height)
                                : ", fov_y_deg = " + number(camera.fov_y_deg);
    text += ", near = " + number(camera.near_plane) + ", far = " + number(camera.far_plane);
  }
  return text + ", reverse_z = " + truth(camera.reverse_z) + shakeAndCutsText(camera) + " }";
}

std::string relativePath(const std::string& path, const fs::path& directory) {
  const fs::path relative = directory.empty() ? fs::path(path) : fs::path(path).lexically_relative(directory);
  const bool below = !relative.empty() && *relative.begin() != "..";
  return quoted(below ? relative.generic_string() : path);
}

std::string shaderText(const Scenario& scenario, const fs::path& directory) {
  std::string text = "\n[shader]\n";
  if (!scenario.fragment_path.empty()) text += "fragment = " + relativePath(scenario.fragment_path, directory) + "\n";
  if (!scenario.vertex_path.empty()) text += "vertex = " + relativePath(scenario.vertex_path, directory) + "\n";
  text += "fragment_entry_point = " + quoted(scenario.fragment_entry_point) +
                     "\nvertex_entry_point = " + quoted(scenario.vertex_entry_point) + "\ninclude_dirs = [";
  for (std::size_t i = 0; i < scenario.include_dirs.size(); ++i)
    text += (i > 0 ? ", " : "") + relativePath(scenario.include_dirs[i], directory);
  text += "]\ndefines = {";
  for (std::size_t i = 0; i < scenario.defines.size(); ++i)
    text += (i > 0 ? ", " : " ") + scenario.defines[i].first + " = " + quoted(scenario.defines[i].second);
  text += " }\n";
  if (scenario.vertex_inputs.empty()) return text;
  text += "vertex_inputs = {";
  for (std::size_t i = 0; i < scenario.vertex_inputs.size(); ++i)
    text += (i > 0 ? ", " : " ") + quoted(scenario.vertex_inputs[i].first) + " = " + quoted(scenario.vertex_inputs[i].second);
  return text + " }\n";
}

std::string renderText(const Scenario& scenario) {
  std::string text = "\n[render]\nwidth = " + std::to_string(scenario.width) +
                     "\nheight = " + std::to_string(scenario.height) +
                     "\nframes = " + std::to_string(scenario.frames) +
                     "\nframe_time_s = " + number(scenario.frame_time_s) + "\nperiods = [";
  for (std::size_t i = 0; i < scenario.periods.size(); ++i) {
    const std::uint32_t period = scenario.periods[i];
    text += (i > 0 ? ", " : "") + (period == 0 ? quoted("never") : std::to_string(period));
  }
  text += "]";
  if (scenario.stereo) text += "\nstereo = { eye_distance = " + number(scenario.stereo->eye_distance) + " }";
  text += "\nseed = " + std::to_string(scenario.seed) +
          "\ncull = " + quoted(spellingOf(kCullModes, scenario.state.cull)) +
          "\ndepth_compare = " + quoted(spellingOf(kDepthCompares, scenario.state.compare)) +
          "\ndepth_stencil = " + truth(scenario.state.depth_stencil) + "\nformats = [";
  for (std::size_t i = 0; i < scenario.state.color_formats.size(); ++i)
    text += (i > 0 ? ", " : "") + quoted(scenario.state.color_formats[i]);
  return text + "]\nclear = " + numbers(scenario.state.clear) +
         "\ntone_map = " + quoted(spellingOf(kToneMaps, scenario.tone_map)) +
         "\nexposure = " + number(scenario.exposure) + "\n";
}

std::string samplerText(const TextureSpec& texture) {
  return "linear = " + truth(texture.linear) + "\nrepeat = " + truth(texture.repeat) +
         "\nmipmaps = " + truth(texture.mipmaps) + "\nsrgb = " + truth(texture.srgb) + "\n";
}

std::string textureText(const TextureSpec& texture, const fs::path& directory) {
  std::string text = "\n[[texture]]\nname = " + quoted(texture.name) + "\n";
  if (texture.kind == TextureKind::kFile) {
    text += "file = " + relativePath(texture.path, directory) + "\n";
  } else if (texture.kind == TextureKind::kDiscs) {
    text += "kind = \"discs\"\nobjects = [";
    for (std::size_t i = 0; i < texture.objects.size(); ++i) text += (i > 0 ? ", " : "") + quoted(texture.objects[i]);
    text += "]\ndiscs_u = " + std::to_string(texture.discs_u) + "\ndiscs_v = " + std::to_string(texture.discs_v) +
            "\nobject_space = " + truth(texture.object_space) + "\n";
  } else {
    text += "kind = " + quoted(spellingOf(kTextureKinds, texture.kind)) +
            "\nsize = " + std::to_string(texture.size) + "\n";
    if (hasCells(texture.kind)) text += "cells = " + std::to_string(texture.cells) + "\n";
    if (hasSeed(texture.kind)) text += "seed = " + std::to_string(texture.seed) + "\n";
    if (texture.kind == TextureKind::kBumps) return text + "height = " + number(texture.height) + "\n" + samplerText(texture);
    text += "color_a = " + numbers(texture.color_a) + "\ncolor_b = " + numbers(texture.color_b) + "\n";
  }
  return text + samplerText(texture);
}

std::string sessionText(const SessionSpec& session) {
  std::string text = "\n[[session]]\nname = " + quoted(session.name) +
                     "\nrole = " + quoted(spellingOf(kSessionRoles, session.role)) +
                     "\ncamera = " + cameraText(session.camera) + "\n";
  if (session.frames > 0) text += "frames = " + std::to_string(session.frames) + "\n";
  text += "speed = " + number(session.speed) + "\n";
  // Dotted keys: a table of its own for each session would have to come last.
  for (const auto& [object, motion] : session.motions)
    text += "motions." + quoted(object) + " = " + motionText(motion) + "\n";
  for (const auto& [member, track] : session.uniforms)
    text += "uniforms." + quoted(member) + " = " + trackText(track) + "\n";
  return text;
}

std::string modelText(const ModelSpec& model, const fs::path& directory) {
  std::string text = "\n[[model]]\nname = " + quoted(model.name) + "\n";
  text += model.path.empty() ? "kind = \"figure\"\nsegments = " + std::to_string(model.segments) + "\n"
                             : "file = " + relativePath(model.path, directory) + "\n";
  if (model.animation) text += "animation = " + quoted(*model.animation) + "\n";
  return text + "speed = " + number(model.speed) + "\nphase_s = " + number(model.phase_s) + "\ncolor = " + numbers(model.color) +
         "\nmotion = " + motionText(model.motion) + "\n";
}

std::string passText(const PassSpec& pass, const fs::path& directory) {
  std::string text = "\n[[pass]]\nname = " + quoted(pass.name) + "\nkind = " + quoted(spellingOf(kScenePassKinds, pass.kind)) + "\n";
  if (pass.kind == ScenePassKind::kShadow) {
    text += "light = " + cameraText(pass.light) + "\ncolor = " + numbers(pass.color) + "\nsize = " + std::to_string(pass.size) +
            "\nslope_bias = " + number(pass.slope_bias) + "\nobjects = [";
    for (std::size_t i = 0; i < pass.objects.size(); ++i) text += (i > 0 ? ", " : "") + quoted(pass.objects[i]);
    return text + "]\n";
  }
  text += "fragment = " + relativePath(pass.fragment_path, directory) + "\n";
  if (!pass.vertex_path.empty()) text += "vertex = " + relativePath(pass.vertex_path, directory) + "\n";
  if (!pass.package.empty()) text += "package = " + relativePath(pass.package, directory) + "\n";
  if (!pass.depth_texture.empty()) text += "depth = " + quoted(pass.depth_texture) + "\n";
  text += "outputs = [";
  for (std::size_t i = 0; i < pass.outputs.size(); ++i) {
    const PassOutput& output = pass.outputs[i];
    text += (i > 0 ? ", " : "") + ("{ texture = " + quoted(output.texture)) + ", format = " + quoted(output.format) +
            ", linear = " + truth(output.linear) + " }";
  }
  return text + "]\n";
}

std::string uniformText(const UniformBinding& binding) {
  if (const auto* source = std::get_if<PassSource>(&binding.source))
    return quoted(binding.member) + " = { " + spellingOf(kPassSources, source->semantic) + " = " + quoted(source->pass) + " }\n";
  const auto* semantic = std::get_if<Semantic>(&binding.source);
  return quoted(binding.member) + " = " +
         (semantic ? quoted(spellingOf(kSemantics, *semantic)) : trackText(std::get<Track>(binding.source))) +
         "\n";
}

}  // namespace

std::string writeScenario(const Scenario& scenario, const fs::path& directory) {
  std::string text =
      "name = " + quoted(scenario.name) + "\n" + shaderText(scenario, directory) + renderText(scenario);
  for (const ModelSpec& model : scenario.models) text += modelText(model, directory);
  for (const Object& object : scenario.objects) {
    if (object.part) continue;
    text += "\n[[object]]\nname = " + quoted(object.name) + "\nmesh = " + meshText(object.mesh) +
            "\nmotion = " + motionText(object.motion) + "\n";
  }
  text += "\n[uniforms]\n";
  for (const UniformBinding& binding : scenario.uniforms) text += uniformText(binding);
  for (const TextureSpec& texture : scenario.textures) text += textureText(texture, directory);
  for (const PassSpec& pass : scenario.passes) text += passText(pass, directory);
  for (const SessionSpec& session : scenario.sessions) text += sessionText(session);
  return text;
}

}  // namespace reprise
