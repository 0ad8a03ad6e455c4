// A color bar with its values and their unit.

import { useEffect, useRef } from "preact/hooks";
import { type MapName, STEPS, colorMap } from "./colors";

/** `ticks` are spread evenly from the low end to the high one. */
export function ColorBar({ map, title, ticks }: { map: MapName; title: string; ticks: string[] }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const context = canvas.current?.getContext("2d");
    context?.putImageData(new ImageData(new Uint8ClampedArray(colorMap(map)), STEPS, 1), 0, 0);
  }, [map]);
  return (
    <figure class="colorbar">
      <figcaption>{title}</figcaption>
      <canvas ref={canvas} width={STEPS} height={1} role="img" aria-label={`Color bar of ${title}, from ${ticks[0]} to ${ticks.at(-1)}`} />
      <div class="ticks" aria-hidden="true">
        {ticks.map((tick) => (
          <span key={tick}>{tick}</span>
        ))}
      </div>
    </figure>
  );
}
