//! What a PNG says to viewers of panoramas: Google's photo sphere metadata, in XMP
//! (developers.google.com/streetview/spherical-metadata).

use lightfall_core::scene::{Projection, Scene};

/// The key under which a PNG holds XMP (XMP specification, part 3, section 1.1.5).
pub(super) const XMP_KEY: &str = "XML:com.adobe.xmp";

/// The XMP of a scene's picture, if the picture is the whole sky.
pub(super) fn panorama(scene: &Scene) -> Option<String> {
    let size = scene.picture.size();
    let is_whole = scene.camera.projection == Projection::Equirectangular && size.x == 2 * size.y;
    is_whole.then(|| {
        let values = [
            ("ProjectionType", "equirectangular".to_owned()),
            ("UsePanoramaViewer", "True".into()),
            ("CroppedAreaImageWidthPixels", size.x.to_string()),
            ("CroppedAreaImageHeightPixels", size.y.to_string()),
            ("FullPanoWidthPixels", size.x.to_string()),
            ("FullPanoHeightPixels", size.y.to_string()),
            ("CroppedAreaLeftPixels", "0".into()),
            ("CroppedAreaTopPixels", "0".into()),
            ("PoseHeadingDegrees", "0".into()),
        ];
        let values: String = values
            .iter()
            .map(|(name, value)| format!("   <GPano:{name}>{value}</GPano:{name}>\n"))
            .collect();
        format!(
            "<?xpacket begin=\"\u{feff}\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n\
             <x:xmpmeta xmlns:x=\"adobe:ns:meta/\">\n \
             <rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\n  \
             <rdf:Description rdf:about=\"\" xmlns:GPano=\"http://ns.google.com/photos/1.0/panorama/\">\n\
             {values}  </rdf:Description>\n </rdf:RDF>\n</x:xmpmeta>\n<?xpacket end=\"r\"?>"
        )
    })
}
