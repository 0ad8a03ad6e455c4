// How surfaces are colored: by a value at each vertex, or by a place along a surface with a grid.

import { DoubleSide, Matrix4, ShaderMaterial, type Texture, Vector4 } from "three";

const VERTEX = /* glsl */ `
  attribute float value;
  attribute vec3 place;
  uniform mat4 pose;
  varying float vValue;
  varying vec3 vPlace;
  varying vec3 vNormal;
  varying vec3 vPosed;
  void main() {
    vValue = value;
    vPlace = place;
    vNormal = normalMatrix * normal;
    vPosed = (pose * vec4(position, 1.0)).xyz;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }`;

// The colors of the map are those on the screen; light scales them, so that hue and saturation stay what they are.
const FRAGMENT = /* glsl */ `
  uniform sampler2D map;
  uniform float low;
  uniform float top;
  uniform float opacity;
  uniform bool byPlace;
  uniform bool grid;
  uniform vec4 section;
  varying float vValue;
  varying vec3 vPlace;
  varying vec3 vNormal;
  varying vec3 vPosed;
  float line(float at) {
    float width = fwidth(at);
    float off = abs(fract(at - 0.5) - 0.5);
    return width > 0.4 ? 0.0 : 1.0 - smoothstep(width, 2.0 * width, off);
  }
  void main() {
    if (dot(vPosed, section.xyz) > section.w) discard;
    float at = byPlace ? vPlace.x : (vValue - low) / (top - low);
    bool isKnown = byPlace ? vPlace.x > -0.001 : vValue > -1e8;
    vec3 color = !isKnown ? vec3(0.62, 0.64, 0.66) : texture2D(map, vec2(clamp(at, 0.002, 0.998), 0.5)).rgb;
    if (grid && vPlace.x > -0.5) {
      float around = atan(vPlace.z, vPlace.y) * 1.2732395;
      float cut = abs(vPlace.z) < 1e-6 ? 0.0 : 1.0;
      float lines = max(line(vPlace.x * 12.0), fwidth(around) > 1.0 ? 0.0 : cut * line(around));
      color *= 1.0 - 0.55 * lines;
    }
    float light = 0.42 + 0.58 * abs(normalize(vNormal).z);
    if (!gl_FrontFacing) color = mix(color, vec3(0.45), 0.6);
    gl_FragColor = vec4(color * light, opacity);
  }`;

export const NO_SECTION = new Vector4(0, 0, 0, 1);

/** A material that colors by the attribute `value`, or by the attribute `place`, in the colors of `map`. */
export function coloredMaterial(map: Texture): ShaderMaterial {
  const uniforms = {
    map: { value: map },
    low: { value: 0 },
    top: { value: 1 },
    opacity: { value: 1 },
    byPlace: { value: true },
    grid: { value: true },
    section: { value: NO_SECTION.clone() },
    pose: { value: new Matrix4() },
  };
  return new ShaderMaterial({ vertexShader: VERTEX, fragmentShader: FRAGMENT, uniforms, side: DoubleSide });
}
