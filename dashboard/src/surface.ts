// One surface, colored by a value at each vertex, to turn. Draws only when something has changed.

import { BufferAttribute, type BufferGeometry, Color, DataTexture, Mesh, OrthographicCamera, Quaternion, Raycaster, Scene, type ShaderMaterial, Vector2, Vector3, WebGLRenderer } from "three";
import { TrackballControls } from "three/examples/jsm/controls/TrackballControls.js";
import { type MapName, STEPS, colorMap } from "./colors";
import { type Frame, frameOf } from "./pair";
import { coloredMaterial } from "./shader";

/** Values at vertices and the colors for them; NaN is gray. */
export interface Coloring {
  values: Float32Array;
  low: number;
  high: number;
  map: MapName;
}

export function texture(map: MapName): DataTexture {
  const made = new DataTexture(colorMap(map), STEPS, 1);
  made.needsUpdate = true;
  return made;
}

export function meshOf(geometry: BufferGeometry): Mesh<BufferGeometry, ShaderMaterial> {
  const n = geometry.getAttribute("position").count;
  if (!geometry.hasAttribute("value")) geometry.setAttribute("value", new BufferAttribute(new Float32Array(n).fill(-1e9), 1));
  const material = coloredMaterial(texture("viridis"));
  material.uniforms.byPlace!.value = false;
  material.uniforms.grid!.value = false;
  return new Mesh(geometry, material);
}

export function paint(mesh: Mesh<BufferGeometry, ShaderMaterial>, { values, low, high, map }: Coloring): void {
  const { uniforms } = mesh.material;
  uniforms.map!.value.dispose();
  uniforms.map!.value = texture(map);
  uniforms.low!.value = low;
  uniforms.top!.value = Math.max(high, low + 1e-12);
  const attribute = mesh.geometry.getAttribute("value") as BufferAttribute;
  // No NaN: what shaders do with it differs.
  for (let v = 0; v < attribute.count; v++) attribute.array[v] = Number.isFinite(values[v]) ? values[v]! : -1e9;
  attribute.needsUpdate = true;
}

/** Looks at a surface from its flattest side, its longest axis from left to right. */
export function lookAt(camera: OrthographicCamera, frame: Frame, radius: number): void {
  camera.up.copy(frame.axes[1]);
  camera.position.copy(frame.center).addScaledVector(frame.axes[2], 4 * radius);
  [camera.near, camera.far, camera.zoom] = [-20 * radius, 40 * radius, 1];
  camera.lookAt(frame.center);
}

/** Sets what of the surface a picture of this size shows: all of it. */
export function fit(camera: OrthographicCamera, frame: Frame, width: number, height: number): void {
  const { low, high } = frame;
  const perPixel = Math.max((2.2 * Math.max(-low.x, high.x)) / width, (2.3 * Math.max(-low.y, high.y, -low.z, high.z)) / height);
  [camera.left, camera.right, camera.top, camera.bottom] = [-width, width, height, -height].map((side) => (side * perPixel) / 2) as [number, number, number, number];
  camera.updateProjectionMatrix();
}

export class SurfaceScene {
  private readonly renderer: WebGLRenderer;
  private readonly camera = new OrthographicCamera();
  private readonly controls: TrackballControls;
  private readonly scene = new Scene();
  private readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  private readonly frame: Frame;
  private readonly radius: number;
  private readonly sizes = new ResizeObserver(() => this.resize());
  private waiting = 0;
  private isDirty = true;

  constructor(
    readonly canvas: HTMLCanvasElement,
    geometry: BufferGeometry,
  ) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: false });
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
    this.mesh = meshOf(geometry);
    this.mesh.frustumCulled = false;
    this.scene.add(this.mesh);
    this.frame = frameOf(geometry);
    this.radius = geometry.boundingSphere?.radius || 1;
    this.controls = new TrackballControls(this.camera, canvas);
    this.controls.staticMoving = true;
    this.controls.rotateSpeed = 3;
    this.controls.addEventListener("change", () => this.redraw());
    this.view();
    this.sizes.observe(canvas);
    const loop = () => {
      this.waiting = requestAnimationFrame(loop);
      this.controls.update();
      if (this.isDirty) this.draw();
    };
    loop();
  }

  dispose(): void {
    cancelAnimationFrame(this.waiting);
    this.sizes.disconnect();
    this.controls.dispose();
    this.mesh.material.dispose();
    this.mesh.geometry.dispose();
    this.renderer.dispose();
  }

  color(coloring: Coloring): void {
    paint(this.mesh, coloring);
    this.redraw();
  }

  /** Moves the vertices; the view stays. */
  move(positions: Float32Array): void {
    const attribute = this.mesh.geometry.getAttribute("position") as BufferAttribute;
    attribute.array.set(positions);
    attribute.needsUpdate = true;
    this.mesh.geometry.computeVertexNormals();
    this.mesh.geometry.computeBoundingSphere();
    this.redraw();
  }

  view(): void {
    this.controls.target.copy(this.frame.center);
    lookAt(this.camera, this.frame, this.radius);
    this.resize();
  }

  turn(right: number, up: number): void {
    const eye = this.camera.position.clone().sub(this.controls.target);
    const side = new Vector3().crossVectors(this.camera.up, eye).normalize();
    const turned = new Quaternion().setFromAxisAngle(this.camera.up.clone().normalize(), right);
    turned.premultiply(new Quaternion().setFromAxisAngle(side, up));
    this.camera.up.applyQuaternion(turned).normalize();
    this.camera.position.copy(this.controls.target).add(eye.applyQuaternion(turned));
    this.camera.lookAt(this.controls.target);
    this.redraw();
  }

  zoom(factor: number): void {
    this.camera.zoom = Math.min(40, Math.max(0.2, this.camera.zoom * factor));
    this.camera.updateProjectionMatrix();
    this.redraw();
  }

  redraw(): void {
    this.isDirty = true;
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height, false);
    fit(this.camera, this.frame, width, height);
    this.controls.handleResize();
    this.redraw();
  }

  private draw(): void {
    this.isDirty = false;
    this.renderer.setClearColor(new Color(getComputedStyle(this.canvas).getPropertyValue("--canvas").trim() || "#f4f6f8"));
    this.renderer.render(this.scene, this.camera);
  }

  /** The vertex nearest to what is seen at this place of the canvas, in CSS pixels. */
  pick(x: number, y: number): number | null {
    const ray = new Raycaster();
    const { clientWidth: width, clientHeight: height } = this.canvas;
    this.camera.updateMatrixWorld();
    ray.setFromCamera(new Vector2((2 * x) / width - 1, 1 - (2 * y) / height), this.camera);
    const hit = ray.intersectObject(this.mesh)[0];
    if (!hit?.face) return null;
    const position = this.mesh.geometry.getAttribute("position");
    const distance = (v: number) => hit.point.distanceToSquared(new Vector3().fromBufferAttribute(position, v));
    return [hit.face.a, hit.face.b, hit.face.c].reduce((best, v) => (distance(v) < distance(best) ? v : best));
  }

  /** Where a vertex is on the canvas, in CSS pixels, and whether its side of the surface faces the viewer. */
  project(vertex: number): { x: number; y: number; facing: number } {
    this.camera.updateMatrixWorld();
    const { geometry } = this.mesh;
    const p = new Vector3().fromBufferAttribute(geometry.getAttribute("position"), vertex).project(this.camera);
    const n = new Vector3().fromBufferAttribute(geometry.getAttribute("normal"), vertex);
    const toward = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 2);
    return { x: ((p.x + 1) / 2) * this.canvas.clientWidth, y: ((1 - p.y) / 2) * this.canvas.clientHeight, facing: n.dot(toward) };
  }

  picture(): Promise<Blob | null> {
    this.draw();
    return new Promise((resolve) => this.canvas.toBlob(resolve, "image/png"));
  }
}
