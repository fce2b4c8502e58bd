// The material of the faces: shaded, zebra stripes, or a map of curvature.
import * as THREE from 'three';

export const MODES = ['shaded', 'zebra', 'curvature'];
export const MEASURES = ['mean', 'gauss', 'largest'];

const VERTEX = `
attribute vec2 curvature;
attribute float fresh;
varying vec3 vNormal3;
varying vec3 vView;
varying vec2 vCurvature;
varying float vFresh;
varying vec3 vPlace;
void main() {
  vPlace = position;
  vec4 at = modelViewMatrix * vec4(position, 1.0);
  vNormal3 = normalMatrix * normal;
  vView = isOrthographic ? vec3(0.0, 0.0, 1.0) : -at.xyz;
  vCurvature = curvature;
  vFresh = fresh;
  gl_Position = projectionMatrix * at;
}`;

const FRAGMENT = `
uniform int mode;
uniform int measure;
uniform float stripes;
uniform float range;
uniform vec3 base;
uniform vec3 freshColour;
uniform float freshShown;
varying vec3 vNormal3;
varying vec3 vView;
varying vec2 vCurvature;
varying float vFresh;
varying vec3 vPlace;
uniform vec4 section;

// Blue over white to brown: safe for colour-blind eyes, and it prints.
vec3 diverging(float t) {
  vec3 low = vec3(0.13, 0.40, 0.67);
  vec3 high = vec3(0.70, 0.35, 0.02);
  vec3 middle = vec3(0.97);
  vec3 far = t < 0.0 ? low : high;
  float s = abs(t);
  return s < 0.5 ? mix(middle, mix(middle, far, 0.75), 2.0 * s)
                 : mix(mix(middle, far, 0.75), far * 0.6, 2.0 * s - 1.0);
}

void main() {
  if (dot(section.xyz, vPlace) > section.w) discard;
  vec3 n = normalize(vNormal3);
  vec3 v = normalize(vView);
  bool inside = dot(n, v) < 0.0;
  if (inside) n = -n;
  float light = 0.45 + 0.40 * max(dot(n, normalize(vec3(0.3, 0.6, 0.8))), 0.0)
                     + 0.22 * max(dot(n, normalize(vec3(-0.7, -0.1, 0.5))), 0.0);
  vec3 colour = base * light;
  if (mode == 1) {
    // Tubes of light around the scene, seen in the mirror that the face is.
    vec3 r = reflect(-v, n);
    float a = stripes * acos(clamp(r.y, -1.0, 1.0)) / 3.14159265;
    float wave = abs(fract(a) - 0.5) * 2.0;
    float soft = clamp(1.5 * fwidth(a), 0.002, 0.5);
    float stripe = smoothstep(0.5 - soft, 0.5 + soft, wave);
    colour = mix(vec3(0.06), vec3(0.95), stripe) * (0.85 + 0.15 * light);
  } else if (mode == 2) {
    float k1 = vCurvature.x;
    float k2 = vCurvature.y;
    float value = measure == 0 ? 0.5 * (k1 + k2)
                : measure == 1 ? sign(k1 * k2) * sqrt(abs(k1 * k2))
                : (abs(k1) > abs(k2) ? k1 : k2);
    colour = diverging(clamp(value / range, -1.0, 1.0)) * (0.72 + 0.28 * light);
  }
  colour = mix(colour, freshColour * (mode == 0 ? light : 1.0), 0.55 * vFresh * freshShown);
  if (inside) colour *= 0.72;
  gl_FragColor = vec4(colour, 1.0);
  #include <colorspace_fragment>
}`;

export function makeFaceMaterial() {
  return new THREE.ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    side: THREE.DoubleSide,
    polygonOffset: true, // so that edges lie on top
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 2,
    uniforms: {
      mode: { value: 0 },
      measure: { value: 0 },
      stripes: { value: 16 },
      range: { value: 1 },
      base: { value: new THREE.Color('#b9c2cc') },
      freshColour: { value: new THREE.Color('#2fa6a0') },
      freshShown: { value: 1 },
      section: { value: new THREE.Vector4(0, 0, 0, 1) }, // what lies beyond this plane is not drawn
    },
  });
}

export function makeFaceGeometry(model, newFaces) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(model.points, 3));
  geometry.setAttribute('normal', new THREE.BufferAttribute(model.normals, 3));
  geometry.setAttribute('curvature', new THREE.BufferAttribute(model.curvatures, 2));
  const fresh = new Uint8Array(model.points.length / 3);
  for (const face of newFaces) {
    const from = 3 * model.first[face - 1];
    const to = 3 * model.first[face];
    for (let i = from; i < to; ++i) fresh[model.corners[i]] = 1;
  }
  geometry.setAttribute('fresh', new THREE.BufferAttribute(fresh, 1));
  geometry.setIndex(new THREE.BufferAttribute(model.corners, 1));
  return geometry;
}

/** The measure of curvature that the map shows. */
export function measured(measure, k1, k2) {
  if (measure === 'mean') return 0.5 * (k1 + k2);
  if (measure === 'gauss') return Math.sign(k1 * k2) * Math.sqrt(Math.abs(k1 * k2));
  return Math.abs(k1) > Math.abs(k2) ? k1 : k2;
}

/** Sizes of curvature over the model, and what part of the curved area is below each: a map whose
 *  range goes by area is not white because of one small fillet, on which most of the points are. */
export function curvatureSpread(model, measure) {
  const { points, corners, curvatures } = model;
  const found = [];
  const triangles = corners.length / 3;
  const step = Math.max(1, Math.ceil(triangles / 60000));
  for (let t = 0; t < triangles; t += step) {
    const [a, b, c] = corners.subarray(3 * t, 3 * t + 3);
    const value = Math.abs(measured(measure, curvatures[2 * a], curvatures[2 * a + 1]));
    if (!(value > 0) || !Number.isFinite(value)) continue;
    const u = [0, 1, 2].map((i) => points[3 * b + i] - points[3 * a + i]);
    const v = [0, 1, 2].map((i) => points[3 * c + i] - points[3 * a + i]);
    const area = Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
    if (area > 0) found.push([value, area]);
  }
  found.sort((p, q) => p[0] - q[0]);
  // Rounding on planes counts as flat.
  const least = found.length > 0 ? 1e-7 * found[found.length - 1][0] : 0;
  const curved = found.filter(([value]) => value > least);
  let sum = 0;
  for (const pair of curved) { sum += pair[1]; pair[1] = sum; }
  return curved.map(([value, below]) => [value, below / sum]);
}

/** The curvature that `part` of the curved area stays below. */
export function curvatureAt(spread, part) {
  if (spread.length === 0) return 1;
  return (spread.find(([, below]) => below >= part) ?? spread[spread.length - 1])[0];
}
