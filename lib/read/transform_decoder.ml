open Candor_space
open Decode
open Fields
open Geometry_decoder

let scale =
  let uniform = length "S" |> map (fun s -> Vec.v s s s) in
  body "S" (fun notes (form : Form.t) ->
      match form.body with
      | [] | [ _ ] -> read_body uniform notes form
      | _ :: _ :: _ -> read_body vector notes form)
  |> map (fun s -> Transform.Scale s)

let rotate =
  fields
    (let+ axis = field "axis" direction
     and+ degrees = field "degrees" (Quantity.scalar "A" Rule.any) in
     Transform.Rotate { axis; degrees })

let matrix =
  let of_rows m =
    Transform.Matrix
      {
        xx = m.(0);
        xy = m.(1);
        xz = m.(2);
        xt = m.(3);
        yx = m.(4);
        yy = m.(5);
        yz = m.(6);
        yt = m.(7);
        zx = m.(8);
        zy = m.(9);
        zz = m.(10);
        zt = m.(11);
      }
  in
  Quantity.numbers "M11 M12 M13 M14 M21 M22 M23 M24 M31 M32 M33 M34" Rule.length
  |> map of_rows

let invertible steps = Result.map (fun _ -> steps) (Transform.of_steps steps)

let one_invertible step =
  Result.map (fun _ -> step) (Transform.of_steps [ step ])

let step =
  choice "step of a transform"
    (List.map
       (fun (head, step) -> (head, check one_invertible step))
       [
         ("translate", vector |> map (fun v -> Transform.Translate v));
         ("scale", scale);
         ("rotate", rotate);
         ("matrix", matrix);
       ])

let steps = fields (items step) |> check invertible
